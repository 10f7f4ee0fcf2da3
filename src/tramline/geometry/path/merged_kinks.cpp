#include "tramline/geometry/path/merged_kinks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Edges by length, then by position; `version` marks those that have changed since.
using Entry = std::tuple<double, std::size_t, unsigned>;

class Merger {
 public:
  Merger(const std::vector<Point>& line, double radius)
      : at_(line), radius_(radius), version_(line.size(), 0) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      before_.push_back(i == 0 ? kNone : i - 1);
      after_.push_back(i + 1 == line.size() ? kNone : i + 1);
    }
  }

  MergedKinks run() {
    for (std::size_t i = 0; i != kNone; i = after_[i]) queue_edge(i);
    while (!queue_.empty() && !out_.hairpin) {
      const auto [length, i, version] = queue_.top();
      queue_.pop();
      if (version == version_[i] && after_[i] != kNone && lacks_room(i)) mend(i);
    }
    for (std::size_t i = 0; i != kNone; i = after_[i]) out_.line.push_back(at_[i]);
    return std::move(out_);
  }

 private:
  bool inner(std::size_t i) const { return before_[i] != kNone && after_[i] != kNone; }
  double turn(std::size_t i) const { return inner(i) ? turn_at(at_[before_[i]], at_[i], at_[after_[i]]) : 0; }
  double tangent_for(double turn) const {
    if (std::abs(turn) > kSharpestTurn) return std::numeric_limits<double>::infinity();
    return radius_ * std::tan(0.5 * std::abs(turn));
  }
  double tangent(std::size_t i) const { return tangent_for(turn(i)); }
  double edge(std::size_t i) const { return distance(at_[i], at_[after_[i]]); }
  bool lacks_room(std::size_t i) const { return tangent(i) + tangent(after_[i]) > edge(i) + kSameDistance_m; }

  void queue_edge(std::size_t i) {
    ++version_[i];
    if (after_[i] != kNone && lacks_room(i)) queue_.emplace(edge(i), i, version_[i]);
  }
  /// The edges whose length or whose ends' turns depend on vertex i.
  void queue_around(std::size_t i) {
    std::size_t first = i;
    for (int back = 0; back < 2 && before_[first] != kNone; ++back) first = before_[first];
    for (int count = 0; count < 4 && first != kNone; ++count, first = after_[first]) queue_edge(first);
  }

  void remove(std::size_t i) {
    ++version_[i];
    if (before_[i] != kNone) after_[before_[i]] = after_[i];
    if (after_[i] != kNone) before_[after_[i]] = before_[i];
    before_[i] = after_[i] = kNone;
  }

  /// Both ends of edge i become one vertex.
  void unite(std::size_t i, Point place) {
    const std::size_t j = after_[i];
    remove(j);
    at_[i] = place;
    drop_if_doubled(i);
  }
  void drop_if_doubled(std::size_t i) {
    std::size_t around = i;
    if (inner(i) && (distance(at_[i], at_[before_[i]]) < kSamePlace_m ||
                     distance(at_[i], at_[after_[i]]) < kSamePlace_m)) {
      around = before_[i];
      remove(i);
    }
    queue_around(around);
  }

  void mend(std::size_t i) {
    const std::size_t j = after_[i];
    if (!inner(i) && !inner(j)) return;
    if (!inner(i) || !inner(j)) return mend_end(i);
    const double at_i = turn(i), at_j = turn(j), together = at_i + at_j;
    const bool same_way = at_i * at_j > 0;
    if (same_way && std::abs(together) < kSharpestTurn) return unite(i, meeting_of_neighbours(i));
    if (!same_way && draw_apart(i)) return;
    const bool noise = edge(i) <= (same_way ? 0.25 : 2) * radius_;
    if (!noise) return refuse(i);
    unite(i, midpoint(at_[i], at_[j]));
  }

  /// An end of the line stays, and the kink next to it goes.
  void mend_end(std::size_t i) {
    if (edge(i) > 2 * radius_) return refuse(i);
    const std::size_t kink = inner(i) ? i : after_[i];
    const std::size_t around = before_[kink];
    remove(kink);
    queue_around(around);
  }

  Point meeting_of_neighbours(std::size_t i) const {
    const std::size_t j = after_[i];
    const Point a = at_[before_[i]], along = at_[i] - a, other = at_[after_[j]] - at_[j];
    return a + (cross(at_[j] - a, other) / cross(along, other)) * along;
  }

  /// Kinks that turn opposite ways: back along the edge before, and on along the edge after, by the least
  /// that makes room for both arcs. False where that leaves too little of these edges.
  bool draw_apart(std::size_t i) {
    const std::size_t j = after_[i], a = before_[i], b = after_[j];
    const double before = edge(a), after = edge(j);
    const Point back = (1 / before) * (at_[a] - at_[i]), on = (1 / after) * (at_[b] - at_[j]);
    const auto room_at = [&](double by) {
      const Point p = at_[i] + by * back, q = at_[j] + by * on;
      const double tangent_p = tangent_for(turn_at(at_[a], p, q));
      const double tangent_q = tangent_for(turn_at(p, q, at_[b]));
      const double between = distance(p, q) - tangent_p - tangent_q - kLeastBetweenArcs_m;
      const double room =
          std::min({between, before - by - tangent(a) - tangent_p, after - by - tangent(b) - tangent_q});
      return std::pair{between, room};
    };
    double low = 0, high = 0.999 * std::min(before, after);
    if (room_at(high).first < 0) return false;
    for (int step = 0; step < 50 && high - low > kRounding_share * high; ++step) {
      const double middle = 0.5 * (low + high);
      (room_at(middle).first < 0 ? low : high) = middle;
    }
    if (room_at(high).second < 0) return false;
    at_[i] = at_[i] + high * back;
    at_[j] = at_[j] + high * on;
    queue_around(i);
    queue_around(j);
    return true;
  }

  /// The sharper end of edge i is the one that cannot be driven.
  void refuse(std::size_t i) {
    const std::size_t j = after_[i];
    out_.hairpin = tangent(j) > tangent(i) ? j : i;
  }

  std::vector<Point> at_;
  double radius_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> after_;
  std::vector<unsigned> version_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  MergedKinks out_;
};

}  // namespace

double turn_at(Point a, Point b, Point c) {
  assert(a != b && b != c);
  return std::atan2(cross(b - a, c - b), dot(b - a, c - b));
}

MergedKinks merged_kinks(const std::vector<Point>& line, double radius_m) {
  assert(line.size() >= 2);
  assert(std::adjacent_find(line.begin(), line.end()) == line.end());
  return Merger(line, radius_m).run();
}

}  // namespace tramline
