#pragma once
// How near a drive kept to the tracks that were planned.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// Distances of the working drive from the nearest planned track or headland pass, weighted by the way
/// driven, m. Only what lies within half a working width of one counts as driven along it.
struct Deviation {
  double mean_m = 0;
  double p95_m = 0;  ///< for 95 % of that way it is no more than this
  double most_m = 0;
  double along_m = 0;   ///< way driven along tracks
  double beside_m = 0;  ///< way driven at work further from every track
};

/// Frame: the plan's field's. Looked at from fix to fix, at the middle of each step. O(steps · tracks near
/// them).
Deviation deviation(const Plan& plan, const std::vector<DrivenLine>& lines);

}  // namespace tramline::coverage
