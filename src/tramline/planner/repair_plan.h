#pragma once
// A plan for the ground that a drive has missed.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"
#include "tramline/planner/repair_lines.h"

namespace tramline {

struct RepairPlan {
  Plan plan;                         ///< its body: the gaps taken on; worked: the rest of the field
  int gaps = 0;                      ///< of the coverage that lie in this field
  int taken = 0;                     ///< of them, worked
  std::vector<LeftGap> ignored;      ///< smaller than the least area, the largest first
  std::vector<LeftGap> unreachable;  ///< gaps and parts of gaps taken on, from the least area
  double missed_before_m2 = 0;       ///< all that is missed, down to the thinnest sliver
  double missed_after_m2 = 0;        ///< of that, what no swath of the plan covers
};

/// Plans tracks over the gaps of at least `min_area_m2` so that nothing of that size is left that a straight
/// swath could work. Each gap gets the grid of lines that costs least (best_lines), gaps are joined where
/// that is cheaper (join_where_it_pays), and what is left of them is worked by further lines in other
/// directions until no swath that keeps within the field would work as much as `min_area_m2` of it, or
/// bring it below that. Such ground is listed as unreachable.
///
/// `field`: outer ring and obstacles, `gaps` and `missed` within it, all in its local metres. Swaths stay in
/// the field and out of obstacles, and run on over worked ground as far as the end rule says; between the
/// pieces of one line the machine drives on with the work off. Prices are those of the objective; see
/// price_of() for short lines. The machine's least length counts for lines, with the default 0.
///
/// Throws kBadInput where there is no gap, none large enough, or none that can be entered. Deterministic for
/// any number of threads.
RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       RepairTerms terms, double min_area_m2, int threads, const RepairProgress& progress);

}  // namespace tramline
