#include "tramline/avoidance/least_with_detours.h"

#include <algorithm>
#include <cmath>

#include "tramline/cost/strip_tally.h"
#include "tramline/geometry/region.h"

namespace tramline {
namespace {

/// Ground of one subfield that detours may work, in its turned plane.
class DetourZones {
 public:
  DetourZones(const AvoidanceTask& task, const TrackFrame& frame) {
    const double arc = std::max(task.machine.radius_m, 0.5 * task.machine.width_m);
    margin_ = task.machine.width_m + 3 * arc;
    for (const Hazard& hazard : task.ground.hazards)
      boxes_.push_back(bounds(frame.to_track(Region{hazard.shape})).grown(margin_));
  }

  /// The stretches of a strip that no detour comes near.
  Intervals far_from(double left, double right, const Interval& whole) const {
    Intervals near;
    for (const Box& box : boxes_)
      if (box.min_x < right && box.max_x > left) near.push_back({box.min_y, box.max_y});
    std::sort(near.begin(), near.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    Intervals joined;
    for (const Interval& one : near) append_joining(joined, one);
    return complement(joined, whole);
  }

 private:
  double margin_ = 0;
  std::vector<Box> boxes_;
};

struct Sums {
  double over_m2 = 0, under_m2 = 0;
  int pieces = 0;
};

/// What one strip costs at least.
void add_strip(const Strip& strip, const std::vector<const StripPiece*>& pieces, const Intervals& far,
               const Interval& whole, double width_m, Sums& sums) {
  Intervals driven;
  for (const StripPiece* piece : pieces) append_joining(driven, {piece->from, piece->to});
  for (const Interval& worked : common(driven, far))
    sums.over_m2 += width_m * worked.length() - area_between(strip.subfield, worked.from, worked.to);
  for (const Interval& left : without(far, driven))
    sums.under_m2 += area_between(strip.subfield, left.from, left.to);
  const bool untouched = far.size() == 1 && far.front() == whole;
  for (const StripPiece* piece : pieces) sums.pieces += untouched ? (piece->after_crossing ? 0 : 1) : 0;
  if (!untouched && !pieces.empty()) ++sums.pieces;
}

}  // namespace

Avoided all_cut(const AvoidanceTask& task) {
  Avoided out;
  for (const Strips& strips : task.strips)
    out.tracks.push_back(cut_pieces(strips, min_length_m(task.machine)));
  out.tally = tally_of(task.subfields, out.tracks, task.body_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

bool meets_obstacles(const AvoidanceTask& task) {
  return std::any_of(task.strips.begin(), task.strips.end(), [](const Strips& strips) {
    return std::any_of(strips.strips.begin(), strips.strips.end(),
                       [](const Strip& strip) { return !hard_gaps(strip).empty(); });
  });
}

double least_with_detours(const AvoidanceTask& task, const Avoided& cut) {
  const double width_m = task.machine.width_m;
  Sums sums;
  double subfields_m2 = 0, own_m2 = 0;
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < task.subfields.size(); ++i) {
    const StripGrid& grid = task.strips[i].grid;
    const DetourZones zones(task, grid.frame);
    const Box reach = bounds(grid.frame.to_track(Region{task.subfields[i].shape}));
    const Interval whole{reach.min_y - 2 * width_m, reach.max_y + 2 * width_m};
    subfields_m2 += area(task.subfields[i].shape);
    dropped += cut.tracks[i].dropped.size();
    auto piece = cut.tracks[i].pieces.begin();
    for (const Strip& strip : task.strips[i].strips) {
      std::vector<const StripPiece*> pieces;
      for (; piece != cut.tracks[i].pieces.end() && piece->strip == strip.index; ++piece) {
        pieces.push_back(&*piece);
        own_m2 += piece->inside_m2;
      }
      const Intervals far = zones.far_from(grid.line(strip.index), grid.line(strip.index + 1), whole);
      add_strip(strip, pieces, far, whole, width_m, sums);
    }
  }
  // Beside its own subfield a swath may work ground of another; a piece too short to be driven may be driven
  // after all where a detour joins it to the next.
  const double across_borders_m2 = std::max(0.0, cut.tally.worked_m2 - cut.tally.overlap_m2 - own_m2) +
                                   static_cast<double>(dropped) * width_m * width_m;
  const Objective& price = task.objective;
  const double shared = task.subfields.size() > 1 ? (price.overlap + price.uncovered) * across_borders_m2 : 0;
  return price.uncovered * (task.body_m2 - subfields_m2) + price.overlap * sums.over_m2 +
         price.uncovered * sums.under_m2 + price.turn * std::max(0, sums.pieces - 1) - shared;
}

}  // namespace tramline
