#include "tramline/geometry/offset/offset_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Relative to an arc's radius: largest rounding of a distance from the arc.
constexpr double kRoundingOfRadius_share = 4e-16;

/// The parallel of one element.
struct Branch {
  Box box;
  Point from;
  Point to;
  double signed_radius = 0;  ///< of an arc
  Point middle;              ///< of an arc: unit vector from the centre to its middle
  bool alive = false;
};

Branch branch_of(const ContourElement& e, double distance) {
  Branch out;
  out.alive = has_parallel(e, distance);
  if (!out.alive) return out;
  if (e.straight) {
    out.from = e.from - distance * left_of(e.heading);
    out.to = out.from + e.length * e.heading;
    out.box = bounds(out.from, out.to);
    return out;
  }
  out.signed_radius = e.signed_radius + distance;
  out.from = e.centre - out.signed_radius * left_of(e.heading);
  out.to = e.centre - out.signed_radius * left_of(e.heading_to);
  out.box = bounds(out.from, out.to).grown(std::abs(out.signed_radius) * (1 - e.half_cosine));
  const Point sum = e.heading + e.heading_to;
  const double norm = length(sum);
  const Point heading =
      norm > kHalfTurn_rad ? (1 / norm) * sum : (e.turn > 0 ? 1.0 : -1.0) * left_of(e.heading);
  out.middle = (out.signed_radius > 0 ? -1.0 : 1.0) * left_of(heading);
  return out;
}

/// A crossing as one of the two branches sees it.
struct Cut {
  double position;
  friend bool operator<(const Cut& a, const Cut& b) { return a.position < b.position; }
};

class FrontMaker {
 public:
  FrontMaker(const Contour& contour, double distance, Sides sides)
      : contour_(contour), distance_(distance), sides_(sides) {
    branches_.reserve(contour.elements.size());
    for (const ContourElement& e : contour.elements) {
      branches_.push_back(branch_of(e, distance));
      same_distance_ =
          std::max(same_distance_, kSameDistance_m + kRoundingOfRadius_share * std::abs(e.signed_radius));
    }
  }

  OffsetFront make() {
    find_cuts();
    const std::size_t n = contour_.segments;
    if (sides_ != Sides::kLeft) add_feet(0, n);
    if (sides_ != Sides::kRight) add_feet(n + 2, 2 * n + 2);
    find_corners();
    return std::move(out_);
  }

 private:
  bool asked_for(std::size_t i) const {
    const std::size_t n = contour_.segments;
    if (i < n) return sides_ != Sides::kLeft;
    return i >= n + 2 && i < 2 * n + 2 && sides_ != Sides::kRight;
  }

  void find_cuts() {
    Box all;
    std::vector<std::size_t> order;
    order.reserve(branches_.size());
    for (std::size_t i = 0; i < branches_.size(); ++i)
      if (branches_[i].alive) {
        all.extend(branches_[i].box);
        order.push_back(i);
      }
    const bool flat = all.width() > all.height();
    const auto low = [&](std::size_t i) { return flat ? branches_[i].box.min_x : branches_[i].box.min_y; };
    const auto high = [&](std::size_t i) { return flat ? branches_[i].box.max_x : branches_[i].box.max_y; };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= high(order[i]); ++j)
        if (intersects(branches_[order[i]].box, branches_[order[j]].box)) cut(order[i], order[j]);
    std::sort(cuts_.begin(), cuts_.end());
  }

  /// Neighbours touch where they join, and nowhere else: their tangents there are the same.
  bool neighbours(std::size_t i, std::size_t j) const {
    const std::size_t apart = i < j ? j - i : i - j;
    return apart == 1 || apart == branches_.size() - 1;
  }

  void cut(std::size_t i, std::size_t j) {
    if (neighbours(i, j) || (!asked_for(i) && !asked_for(j))) return;
    const bool i_straight = contour_.elements[i].straight, j_straight = contour_.elements[j].straight;
    if (i_straight && j_straight) return cut_lines(i, j);
    if (i_straight) return cut_line_and_arc(i, j);
    if (j_straight) return cut_line_and_arc(j, i);
    cut_arcs(i, j);
  }

  void cut_lines(std::size_t i, std::size_t j) {
    const ContourElement &a = contour_.elements[i], &b = contour_.elements[j];
    const double turn = cross(a.heading, b.heading);
    if (std::abs(turn) < kParallelBranches_rad) return;
    const Point between = branches_[j].from - branches_[i].from;
    add(i, cross(between, b.heading) / turn, j, cross(between, a.heading) / turn);
  }

  void cut_line_and_arc(std::size_t line, std::size_t arc) {
    const ContourElement& e = contour_.elements[line];
    const Point to_centre = contour_.elements[arc].centre - branches_[line].from;
    const double foot = dot(to_centre, e.heading), off = cross(e.heading, to_centre);
    const double radius = branches_[arc].signed_radius, square = (radius - off) * (radius + off);
    if (square < 0) return;
    const double half = std::sqrt(square);
    for (const double along : {foot - half, foot + half}) {
      if (along < -kTouch_m || along > e.length + kTouch_m) continue;
      const Point p = branches_[line].from + along * e.heading;
      if (const double on_arc = along_arc(arc, p); on_arc >= 0) add(line, along, arc, on_arc);
    }
  }

  void cut_arcs(std::size_t i, std::size_t j) {
    const Point apart = contour_.elements[j].centre - contour_.elements[i].centre;
    const double square = dot(apart, apart);
    if (square < kConcentric_m2) return;
    const double a = branches_[i].signed_radius, b = branches_[j].signed_radius;
    const double share = 0.5 * (1 + (a - b) * (a + b) / square);
    const double height = a * a - share * share * square;
    if (height < 0) return;
    const double off = std::sqrt(height / square);
    for (const double sense : {-off, off}) {
      const Point p = contour_.elements[i].centre + share * apart + sense * left_of(apart);
      const double on_i = along_arc(i, p), on_j = along_arc(j, p);
      if (on_i >= 0 && on_j >= 0) add(i, on_i, j, on_j);
    }
  }

  /// Position of p along the element, in its own measure; negative where p is not on the arc.
  double along_arc(std::size_t i, Point p) const {
    const ContourElement& e = contour_.elements[i];
    const Branch& branch = branches_[i];
    const Point from_centre = p - e.centre;
    const double radius = std::abs(branch.signed_radius);
    const Point from_start = p - branch.from, from_end = p - branch.to;
    if (dot(from_centre, branch.middle) < e.half_cosine * radius - kTouch_m &&
        std::min(dot(from_start, from_start), dot(from_end, from_end)) > kTouch_m * kTouch_m)
      return -1;
    const Point at_start = branch.from - e.centre;
    const double angle = std::atan2(cross(at_start, from_centre), dot(at_start, from_centre));
    const double share = angle / e.turn;  // of half a circle the end may come out as −1
    return share < -0.5 ? e.length : e.length * std::clamp(share, 0.0, 1.0);
  }

  void add(std::size_t i, double along_i, std::size_t j, double along_j) {
    const ContourElement &a = contour_.elements[i], &b = contour_.elements[j];
    if (along_i < -kTouch_m || along_i > a.length + kTouch_m) return;
    if (along_j < -kTouch_m || along_j > b.length + kTouch_m) return;
    if (asked_for(i)) cuts_.push_back({a.start + std::clamp(along_i, 0.0, a.length)});
    if (asked_for(j)) cuts_.push_back({b.start + std::clamp(along_j, 0.0, b.length)});
  }

  /// Runs of elements that reach the distance, cut into parts.
  void add_feet(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last;) {
      if (!branches_[i].alive) {
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < last && branches_[end].alive) ++end;
      const double from = contour_.elements[i].start;
      const double to = contour_.elements[end - 1].start + contour_.elements[end - 1].length;
      double at = from;
      std::size_t element = i;
      for (auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), Cut{from});; ++cut) {
        const bool done = cut == cuts_.end() || cut->position >= to;
        const double next = done ? to : cut->position;
        if (next > at + kShortest_m) {
          element = add_part(at, next, element);
          at = next;
        }
        if (done) break;
      }
      i = end;
    }
  }

  /// A part is tested in the middle of the longest element on it. Returns the element where it ends.
  std::size_t add_part(double from, double to, std::size_t element) {
    double longest = -1, position = 0;
    std::size_t at = element;
    for (;; ++element) {
      const ContourElement& e = contour_.elements[element];
      const double low = std::max(from, e.start), high = std::min(to, e.start + e.length);
      if (high - low > longest) {
        longest = high - low;
        position = 0.5 * (low + high);
        at = element;
      }
      if (e.start + e.length >= to) break;
    }
    if (keeps_away(contour_, beside(contour_.elements[at], position, distance_), distance_ - same_distance_,
                   nearer_)) {
      if (!out_.feet.empty() && from - out_.feet.back().to < kSameFoot_m)
        out_.feet.back().to = to;
      else
        out_.feet.push_back({from, to});
    }
    return element;
  }

  void find_corners() {
    struct End {
      Point point;
      Point heading;
      double position;
    };
    std::vector<End> starts;
    for (const Interval& feet : out_.feet) {
      std::size_t i = element_at(contour_, feet.from);
      if (contour_.elements[i].start + contour_.elements[i].length <= feet.from) ++i;
      const ContourElement& e = contour_.elements[i];
      starts.push_back({beside(e, feet.from, distance_), heading_at(e, feet.from), feet.from});
    }
    const auto by_x = [](const End& a, const End& b) { return a.point.x < b.point.x; };
    std::sort(starts.begin(), starts.end(), by_x);
    for (const Interval& feet : out_.feet) {
      const ContourElement& e = contour_.elements[element_at(contour_, feet.to)];
      const Point end = beside(e, feet.to, distance_), heading = heading_at(e, feet.to);
      double least = kFrontsMeet_m;
      const End* best = nullptr;
      double turn = 0;
      auto next =
          std::lower_bound(starts.begin(), starts.end(), End{{end.x - kFrontsMeet_m, 0}, {}, 0}, by_x);
      for (; next != starts.end() && next->point.x <= end.x + kFrontsMeet_m; ++next) {
        const End& start = *next;
        const double apart = distance(start.point, end);
        if (apart >= least) continue;
        double right = -std::atan2(cross(heading, start.heading), dot(heading, start.heading));
        if (right < -std::numbers::pi + kHalfTurn_rad) right = -right;  // half a turn, either way
        if (right < -kFrontCorner_rad) continue;
        least = apart;
        best = &start;
        turn = std::max(0.0, right);
      }
      if (best != nullptr)
        out_.corners.push_back({feet.to, best->position, midpoint(end, best->point), turn});
    }
  }

  const Contour& contour_;
  double distance_;
  Sides sides_;
  double same_distance_ = kSameDistance_m;
  std::vector<Branch> branches_;
  std::vector<Cut> cuts_;
  std::size_t nearer_ = 0;
  OffsetFront out_;
};

}  // namespace

OffsetFront offset_front(const Contour& contour, double distance_m, Sides sides) {
  return FrontMaker(contour, distance_m, sides).make();
}

}  // namespace tramline
