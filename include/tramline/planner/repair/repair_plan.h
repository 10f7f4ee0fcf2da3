#pragma once
// A plan for the ground that a drive has missed.

#include <string>
#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"
#include "tramline/planner/repair/repair_terms.h"

namespace tramline {

/// Missed ground that a repair leaves.
struct LeftGap {
  int number = 0;  ///< of the gap in the coverage, from 1
  double area_m2 = 0;
  Point at;  ///< within it
  std::string why;
};

struct RepairPlan {
  Plan plan;                         ///< its body: the gaps taken on; worked: the rest of the field
  int gaps = 0;                      ///< of the coverage that lie in this field
  int taken = 0;                     ///< of them, worked, or what is worth it of them
  std::vector<LeftGap> ignored;      ///< smaller than the least area, the largest first
  std::vector<LeftGap> unreachable;  ///< where no swath in a direction driven there gets in
  std::vector<LeftGap> not_worth;    ///< a pass over them costs more than it wins back
  double missed_before_m2 = 0;       ///< all that is missed, down to the thinnest sliver
  double missed_after_m2 = 0;        ///< of that, what no swath of the plan covers
  double cost_if_left = 0;           ///< missed_before_m2 at the price of missed land
  double cost_of_passes = 0;  ///< overlap, turns and stops of the plan, and a turn for the way to the first
  double cost_after = 0;      ///< of the passes, and of missed_after_m2
};

/// Plans passes over the gaps of at least `min_area_m2`, as far as they win back more than they cost:
/// chosen_lines() in the directions driven there (driven_directions.h). All other gaps are listed with the
/// reason.
///
/// `field`: outer ring and obstacles, `gaps`, `missed` and `driven` within it, all in its local metres.
/// Swaths stay in the field and out of obstacles, and run on over worked ground as far as the end rule says;
/// between the pieces of one line the machine drives on with the work off. Prices are those of the objective;
/// see price_of() for short pieces. The machine's least length counts for lines, with the default 0.
///
/// Throws kBadInput where there is no gap, none large enough, none that can be entered, or none that is worth
/// a pass. Deterministic for any number of threads, unless the progress wants an end (plan_field()).
RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       const std::vector<DrivenLine>& driven, RepairTerms terms, double min_area_m2,
                       int threads, const Progress& progress);

}  // namespace tramline
