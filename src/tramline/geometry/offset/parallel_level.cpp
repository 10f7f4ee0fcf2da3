#include "tramline/geometry/offset/parallel_level.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/path/simplified_line.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Bends whose parallel is tighter than the machine can follow.
Intervals tight_bends(const Contour& contour, double distance, double least_radius) {
  Intervals out;
  for (const ContourElement& e : contour.elements) {
    if (e.straight || e.cap) continue;
    const bool gone = !reaches(e, distance);
    if (gone || std::abs(e.reach + distance) < least_radius * (1 - kRounding_share))
      append_joining(out, {e.start, e.start + e.length});
  }
  return out;
}

bool begins_before(const Interval& a, double place) { return a.from < place; }

/// The stretch in which a place lies; the wide places lie in stretches but for rounding. O(log n).
std::size_t stretch_at(const Intervals& stretches, double place) {
  const auto next = std::lower_bound(stretches.begin(), stretches.end(), place - kSamePlace_m, begins_before);
  if (next != stretches.end() && next->from <= place + kSamePlace_m && next->to >= place)
    return static_cast<std::size_t>(next - stretches.begin());
  if (next != stretches.begin() && (next - 1)->to >= place - kSamePlace_m)
    return static_cast<std::size_t>(next - stretches.begin()) - 1;
  return stretches.size();
}

class Joiner {
 public:
  Joiner(ParallelLevel& level, const std::vector<OffsetCorner>& corners, double sharpest)
      : level_(level), corners_(corners), sharpest_(sharpest) {}

  void run() {
    const std::size_t n = level_.stretches.size();
    std::vector<bool> left(n, false), entered(n, false);
    for (const OffsetCorner& corner : corners_) {
      const std::size_t before = stretch_at(level_.stretches, corner.before);
      const std::size_t after = stretch_at(level_.stretches, corner.after);
      if (before == n || after == n || corner.turn_rad > sharpest_) continue;
      // A stretch that is wide again further on passes a narrow place: it is not left before that.
      if (!last_wide(before, corner.before) || !first_wide(after, corner.after)) continue;
      if (before == after && corner.after > corner.before) continue;
      if (left[before] || entered[after]) continue;
      left[before] = entered[after] = true;
      level_.joins.push_back({before, after, corner});
    }
  }

 private:
  bool last_wide(std::size_t stretch, double place) const {
    const auto next = std::lower_bound(level_.wide.begin(), level_.wide.end(), place, begins_before);
    return next == level_.wide.end() || next->from >= level_.stretches[stretch].to - kSamePlace_m;
  }
  bool first_wide(std::size_t stretch, double place) const {
    const auto own = std::lower_bound(level_.wide.begin(), level_.wide.end(), place, begins_before);
    return own == level_.wide.begin() || (own - 1)->to <= level_.stretches[stretch].from + kSamePlace_m;
  }

  ParallelLevel& level_;
  const std::vector<OffsetCorner>& corners_;
  double sharpest_;
};

/// What the stretches have in the corners that arcs cut off: ends beyond joins, and stretches without room
/// for a disc that lie between the two branches that are joined.
class CutOff {
 public:
  CutOff(const Contour& contour, const TrackLimits& limits, ParallelLevel& level)
      : contour_(contour), limits_(limits), level_(level) {}

  void run() {
    const std::size_t whole = level_.stretches.size();
    std::vector<bool> joined(whole, false);
    for (const TrackJoin& join : level_.joins) {
      joined[join.before] = joined[join.after] = true;
      trim(level_.stretches[join.before].to, join.corner.before);
      trim(join.corner.after, level_.stretches[join.after].from);
      level_.stretches[join.before].to = join.corner.before;
      level_.stretches[join.after].from = join.corner.after;
    }
    for (std::size_t i = 0; i < level_.stretches.size(); ++i)
      if (i >= whole || (!joined[i] && !any_wide(level_.stretches[i])))
        for (const TrackJoin& join : level_.joins) lose(level_.stretches[i], join.corner);
    std::sort(level_.lost.begin(), level_.lost.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
  }

 private:
  void trim(double to, double from) {
    if (to - from > kSamePlace_m) level_.stretches.push_back({from, to});
  }
  bool any_wide(const Interval& stretch) const { return !common({stretch}, level_.wide).empty(); }

  /// Only what lies between the branches, on the way from one to the other, is in the corner.
  void lose(const Interval& stretch, const OffsetCorner& corner) {
    const double slack = kSamePlace_m;
    const bool after = stretch.from >= corner.before - slack, before = stretch.to <= corner.after + slack;
    if (corner.before < corner.after ? !(after && before) : !(after || before)) return;
    const double half = 0.5 * limits_.width_m, least = limits_.least_radius_m();
    // The arc's swath, or the tip of the corner where that is farther off, and then not for a metre or two.
    const double tip = (least - half) / std::max(0.05, std::cos(0.5 * corner.turn_rad));
    const double reach = std::max(least + half, tip) + limits_.width_m;
    const int count = static_cast<int>(4 * stretch.length() / limits_.width_m) + 2;
    const double step = stretch.length() / count;
    Interval near{stretch.to, stretch.from};
    for (int i = 0; i <= count; ++i) {
      const double place = stretch.from + i * step;
      const ContourElement& e = contour_.elements[element_at(contour_, place)];
      const Point a = beside(e, place, level_.distance_m - half);
      const Point b = beside(e, place, level_.distance_m + least);
      if (distance_to_segment(corner.place, a, b) > reach) continue;
      near.from = std::min(near.from, std::max(stretch.from, place - step));
      near.to = std::max(near.to, std::min(stretch.to, place + step));
    }
    if (near.from < near.to) level_.lost.push_back(near);
  }

  const Contour& contour_;
  const TrackLimits& limits_;
  ParallelLevel& level_;
};

}  // namespace

ParallelLevel parallel_level(const Contour& contour, double distance_m, const TrackLimits& limits,
                             Sides sides) {
  const double least_radius = limits.least_radius_m(), half_width = 0.5 * limits.width_m;
  OffsetFront far = offset_front(contour, distance_m + least_radius, sides);
  ParallelLevel out;
  out.distance_m = distance_m;
  out.wide = std::move(far.feet);
  const Intervals swath =
      least_radius > half_width ? offset_front(contour, distance_m + half_width, sides).feet : out.wide;
  out.stretches = without(swath, tight_bends(contour, distance_m, least_radius));
  std::erase_if(out.stretches, [](const Interval& stretch) { return stretch.length() < kSamePlace_m; });
  Joiner(out, far.corners, limits.sharpest_corner.radians()).run();
  CutOff(contour, limits, out).run();
  return out;
}

}  // namespace tramline
