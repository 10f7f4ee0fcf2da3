#include "tramline/planner/candidate/parallel_tracks.h"

#include <cassert>
#include <cmath>

#include "tramline/planner/candidate/reference_chains.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

/// Whether the reference leads all the way round the land, counter-clockwise like outer rings.
bool goes_round(const Path& reference) {
  return distance(reference.front().from, reference.back().to) <= 2 * kSeam_m;
}

StripRange tracks_inside(const Box& reach, double width_m) {
  const double across = std::hypot(reach.width(), reach.height());
  return {-static_cast<int>(std::ceil(0.5 * across / width_m)) - 1, 0};
}

}  // namespace

CurvedGround curved_ground(const SearchTask& task, const Polygon& shape) {
  return {EdgeIndex(Region{shape}), EdgeIndex(task.ground.hard), EdgeIndex(task.hard_field),
          EdgeIndex(task.ground.passable), EdgeIndex(task.ground.beyond)};
}

TrackLimits track_limits(const Machine& machine) {
  TrackLimits limits;
  limits.radius_m = machine.radius_m;
  limits.width_m = machine.width_m;
  return limits;
}

StripRange parallels_over(const SearchTask& task, const Subfield& subfield) {
  assert(!subfield.reference.empty());
  const Box reach = bounds(subfield.shape);
  const double width_m = task.machine.width_m;
  return goes_round(subfield.reference) ? tracks_inside(reach, width_m)
                                        : tracks_over(subfield.reference, reach, width_m);
}

EndCriterion end_criterion_of(const SearchTask& task) {
  return end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
}

TrackFamily parallel_tracks(const SearchTask& task, const CurvedGround& ground, const Subfield& subfield) {
  const StripRange range = parallels_over(task, subfield);
  return curved_tracks(
      parallel_family(subfield.reference, range.first, range.last, track_limits(task.machine)),
      task.machine.width_m, ground, end_criterion_of(task));
}

}  // namespace tramline
