#include "tramline/geometry/offset/parallel_pair.h"

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
    const bool gone = !has_parallel(e, distance);
    if (gone || std::abs(e.signed_radius + distance) < least_radius * (1 - kRounding_share))
      append_joining(out, {e.start, e.start + e.length});
  }
  return out;
}

bool begins_before(const Interval& a, double position) { return a.from < position; }

/// The stretch in which a position lies; wide positions lie in stretches but for rounding. O(log n).
std::size_t stretch_at(const Intervals& stretches, double position) {
  const auto next =
      std::lower_bound(stretches.begin(), stretches.end(), position - kSamePlace_m, begins_before);
  if (next != stretches.end() && next->from <= position + kSamePlace_m && next->to >= position)
    return static_cast<std::size_t>(next - stretches.begin());
  if (next != stretches.begin() && (next - 1)->to >= position - kSamePlace_m)
    return static_cast<std::size_t>(next - stretches.begin()) - 1;
  return stretches.size();
}

class Joiner {
 public:
  Joiner(ParallelPair& pair, const std::vector<OffsetCorner>& corners, double sharpest)
      : pair_(pair), corners_(corners), sharpest_(sharpest) {}

  void run() {
    const std::size_t n = pair_.stretches.size();
    std::vector<bool> exited(n, false), entered(n, false);
    for (const OffsetCorner& corner : corners_) {
      const std::size_t before = stretch_at(pair_.stretches, corner.before);
      const std::size_t after = stretch_at(pair_.stretches, corner.after);
      if (before == n || after == n || corner.turn_rad > sharpest_) continue;
      // A stretch that is wide again further on passes a narrow part: it is not left before that.
      if (!last_wide(before, corner.before) || !first_wide(after, corner.after)) continue;
      if (before == after && corner.after > corner.before) continue;
      if (exited[before] || entered[after]) continue;
      exited[before] = entered[after] = true;
      pair_.joins.push_back({before, after, corner});
    }
  }

 private:
  bool last_wide(std::size_t stretch, double position) const {
    const auto next = std::lower_bound(pair_.wide.begin(), pair_.wide.end(), position, begins_before);
    return next == pair_.wide.end() || next->from >= pair_.stretches[stretch].to - kSamePlace_m;
  }
  bool first_wide(std::size_t stretch, double position) const {
    const auto own = std::lower_bound(pair_.wide.begin(), pair_.wide.end(), position, begins_before);
    return own == pair_.wide.begin() || (own - 1)->to <= pair_.stretches[stretch].from + kSamePlace_m;
  }

  ParallelPair& pair_;
  const std::vector<OffsetCorner>& corners_;
  double sharpest_;
};

/// The parts of the stretches in the corners that arcs cut off: ends beyond joins, and stretches without room
/// for a disc that lie between two joined branches.
class CutOff {
 public:
  CutOff(const Contour& contour, const TrackLimits& limits, ParallelPair& pair)
      : contour_(contour), limits_(limits), pair_(pair) {}

  void run() {
    const std::size_t whole = pair_.stretches.size();
    std::vector<bool> joined(whole, false);
    for (const TrackJoin& join : pair_.joins) {
      joined[join.before] = joined[join.after] = true;
      trim(pair_.stretches[join.before].to, join.corner.before);
      trim(join.corner.after, pair_.stretches[join.after].from);
      pair_.stretches[join.before].to = join.corner.before;
      pair_.stretches[join.after].from = join.corner.after;
    }
    for (std::size_t i = 0; i < pair_.stretches.size(); ++i)
      if (i >= whole || (!joined[i] && !any_wide(pair_.stretches[i])))
        for (const TrackJoin& join : pair_.joins) lose(pair_.stretches[i], join.corner);
    std::sort(pair_.lost.begin(), pair_.lost.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
  }

 private:
  void trim(double to, double from) {
    if (to - from > kSamePlace_m) pair_.stretches.push_back({from, to});
  }
  bool any_wide(const Interval& stretch) const { return !common({stretch}, pair_.wide).empty(); }

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
      const double position = stretch.from + i * step;
      const ContourElement& e = contour_.elements[element_at(contour_, position)];
      const Point a = beside(e, position, pair_.distance_m - half);
      const Point b = beside(e, position, pair_.distance_m + least);
      if (distance_to_segment(corner.point, a, b) > reach) continue;
      near.from = std::min(near.from, std::max(stretch.from, position - step));
      near.to = std::max(near.to, std::min(stretch.to, position + step));
    }
    if (near.from < near.to) pair_.lost.push_back(near);
  }

  const Contour& contour_;
  const TrackLimits& limits_;
  ParallelPair& pair_;
};

}  // namespace

ParallelPair parallel_pair(const Contour& contour, double distance_m, const TrackLimits& limits,
                           Sides sides) {
  const double least_radius = limits.least_radius_m(), half_width = 0.5 * limits.width_m;
  OffsetFront far = offset_front(contour, distance_m + least_radius, sides);
  ParallelPair out;
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
