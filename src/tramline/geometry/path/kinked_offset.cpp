#include "tramline/geometry/path/kinked_offset.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/line_crossing.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// An end of an edge on its way outwards: at `at` when the front is `since_m` off the line, then `speed` for
/// each metre that the front moves.
struct Joint {
  Point at;
  double since_m = 0;
  Point speed;

  Point when(double off_m) const { return at + (off_m - since_m) * speed; }
};

/// The edges of the line moving sideways together.
class Front {
 public:
  Front(const std::vector<Point>& line, bool right) : right_(right) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Point along = unit(line[i + 1] - line[i]);
      if (i > 0 && turns_away_sharply(along_.back(), along))
        append(line[i], middle_of_turn(along_.back(), along));
      append(line[i], along);
    }
    joints_.push_back({line.back(), 0, normal(along_.back())});
  }

  /// Moves the front on, leaving out edges as they vanish.
  void move_to(double off_m) {
    double now_m = 0;
    while (!along_.empty()) {
      std::size_t first = along_.size();
      double when_m = off_m;
      for (std::size_t i = 0; i < along_.size(); ++i) {
        const double vanishes_m = vanishing(i, now_m);
        if (vanishes_m >= when_m) continue;
        when_m = vanishes_m;
        first = i;
      }
      if (first == along_.size()) break;
      now_m = when_m;
      leave_out(first, now_m);
    }
    off_m_ = off_m;
  }

  std::vector<Point> points() const {
    std::vector<Point> out;
    if (along_.empty()) return out;
    for (const Joint& joint : joints_) {
      const Point p = joint.when(off_m_);
      if (out.empty() || distance(out.back(), p) > kShortest_m) out.push_back(p);
    }
    if (out.size() < 2) out.clear();
    return out;
  }

 private:
  static Point unit(Point p) { return (1 / length(p)) * p; }
  Point normal(Point along) const { return right_ ? Point{along.y, -along.x} : Point{-along.y, along.x}; }

  bool turns_away_sharply(Point before, Point after) const {
    const bool away = right_ == (cross(before, after) > 0);
    return away && dot(before, after) < -0.5;
  }

  /// Heading half way between the two; a turn straight back also turns away from the front.
  Point middle_of_turn(Point before, Point after) const {
    const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
    const double half = (right_ ? 0.5 : -0.5) * turn, c = std::cos(half), s = std::sin(half);
    return {before.x * c - before.y * s, before.x * s + before.y * c};
  }

  /// Velocity of the corner between two edges per metre of the front: along the bisector.
  Point mitre_speed(Point before, Point after) const {
    constexpr double kNearlyBack = 0.02;  // turns of 168° and more have no corner to speak of
    const Point a = normal(before), b = normal(after);
    return (1 / std::max(kNearlyBack, 1 + dot(a, b))) * (a + b);
  }

  void append(Point from, Point along) {
    joints_.push_back({from, 0, along_.empty() ? normal(along) : mitre_speed(along_.back(), along)});
    along_.push_back(along);
  }

  /// Offset at which edge i has no length any more; infinite if it grows.
  double vanishing(std::size_t i, double now_m) const {
    const double length_m = dot(joints_[i + 1].when(now_m) - joints_[i].when(now_m), along_[i]);
    const double shrinks = -dot(joints_[i + 1].speed - joints_[i].speed, along_[i]);
    constexpr double kStandsStill = 1e-12;
    if (shrinks <= kStandsStill) return std::numeric_limits<double>::infinity();
    return now_m + std::max(0.0, length_m) / shrinks;
  }

  void leave_out(std::size_t i, double now_m) {
    Joint met{midpoint(joints_[i].when(now_m), joints_[i + 1].when(now_m)), now_m, {}};
    along_.erase(along_.begin() + static_cast<std::ptrdiff_t>(i));
    joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(i));
    if (along_.empty()) return;
    if (i == 0)
      met.speed = normal(along_.front());
    else if (i == along_.size())
      met.speed = normal(along_.back());
    else
      met.speed = mitre_speed(along_[i - 1], along_[i]);
    joints_[i] = met;
  }

  bool right_;
  std::vector<Point> along_;   ///< unit vectors of the edges
  std::vector<Joint> joints_;  ///< before each edge, and after the last
  double off_m_ = 0;
};

/// A point where the line crosses itself, as one of the two edges passes it.
struct Passage {
  std::size_t edge;
  double share;  ///< of the edge
  Point at;
  std::size_t partner = 0;  ///< index of the passage on the other edge
};

std::vector<Passage> passages_of(const std::vector<Point>& line) {
  std::vector<Passage> out;
  std::vector<std::size_t> order, place;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
      const auto s = crossing_along(line[i], line[i + 1], line[j], line[j + 1]);
      if (!s) continue;
      const auto t = crossing_along(line[j], line[j + 1], line[i], line[i + 1]);
      const Point at = line[i] + *s * (line[i + 1] - line[i]);
      out.push_back({i, *s, at, out.size() + 1});
      out.push_back({j, t.value_or(0), at, out.size() - 1});
    }
  for (std::size_t i = 0; i < out.size(); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(), [&out](std::size_t a, std::size_t b) {
    return out[a].edge != out[b].edge ? out[a].edge < out[b].edge : out[a].share < out[b].share;
  });
  place.resize(out.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Passage> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(out[i]);
    sorted.back().partner = place[out[i].partner];
  }
  return sorted;
}

/// The line cut where it crosses itself, and joined again without the parts that lie too near.
class Trimmer {
 public:
  Trimmer(const std::vector<Point>& line, const std::vector<Point>& source, double off_m)
      : source_(source),
        least_m_(off_m * (1 - kPathRadius_share) - kSameDistance_m),
        passages_(passages_of(line)) {
    for (std::size_t i = 0; i <= passages_.size(); ++i) {
      parts_.push_back(part_of(line, i));
      keeps_off_.push_back(keeps_off(parts_.back()));
    }
  }

  std::vector<Point> longest() const {
    std::vector<Point> best;
    double most_m = 0;
    std::vector<bool> used(parts_.size(), false);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (used[i] || !keeps_off_[i]) continue;
      std::vector<Point> line = followed_from(i, used);
      const double length_m = line.size() < 2 ? 0 : length(polyline_path(line));
      if (length_m <= most_m) continue;
      most_m = length_m;
      best = std::move(line);
    }
    return best;
  }

 private:
  /// Between passage i − 1 and passage i.
  std::vector<Point> part_of(const std::vector<Point>& line, std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : passages_[i - 1].edge + 1;
    const std::size_t last = i == passages_.size() ? line.size() - 1 : passages_[i].edge;
    std::vector<Point> out;
    if (i > 0) out.push_back(passages_[i - 1].at);
    for (std::size_t k = first; k <= last; ++k) out.push_back(line[k]);
    if (i < passages_.size()) out.push_back(passages_[i].at);
    return out;
  }

  /// Tested at the middle of its longest edge.
  bool keeps_off(const std::vector<Point>& part) const {
    double longest_m = 0;
    Point middle{};
    for (std::size_t k = 0; k + 1 < part.size(); ++k) {
      if (distance(part[k], part[k + 1]) <= longest_m) continue;
      longest_m = distance(part[k], part[k + 1]);
      middle = midpoint(part[k], part[k + 1]);
    }
    if (longest_m <= kShortest_m) return true;
    for (std::size_t k = 0; k + 1 < source_.size(); ++k)
      if (distance_to_edge({source_[k], source_[k + 1], 0}, middle, middle) < least_m_) return false;
    return true;
  }

  /// The line followed from part to part, at every crossing as far ahead as possible.
  std::vector<Point> followed_from(std::size_t part, std::vector<bool>& used) const {
    std::vector<Point> out;
    for (std::size_t i = part;;) {
      used[i] = true;
      for (const Point p : parts_[i])
        if (out.empty() || distance(out.back(), p) > kShortest_m) out.push_back(p);
      if (i == passages_.size()) return out;
      const std::size_t straight_on = i + 1, across = passages_[i].partner + 1;
      const auto open = [&](std::size_t next) { return keeps_off_[next] && !used[next]; };
      const std::size_t far = std::max(straight_on, across), near = std::min(straight_on, across);
      if (open(far))
        i = far;
      else if (open(near))
        i = near;
      else
        return out;
    }
  }

  const std::vector<Point>& source_;
  double least_m_;
  std::vector<Passage> passages_;
  std::vector<std::vector<Point>> parts_;
  std::vector<bool> keeps_off_;
};

}  // namespace

std::vector<Point> kinked_offset(const std::vector<Point>& line, double offset_m) {
  assert(line.size() >= 2);
  assert(std::adjacent_find(line.begin(), line.end()) == line.end());
  Front front(line, offset_m > 0);
  front.move_to(std::abs(offset_m));
  std::vector<Point> out = front.points();
  if (out.size() < 2 || !self_crossing(out)) return out;
  return Trimmer(out, line, std::abs(offset_m)).longest();
}

}  // namespace tramline
