#pragma once
// A plan for the land that a drive has missed.

#include <string>
#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/model/machine.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"

namespace tramline {

/// The machine, prices and end rule of a repair.
struct RepairTerms {
  Machine machine;
  Objective objective;
  EndRule end_rule = EndRule::kCheapest;
};

/// A gap that a repair does not work.
struct UnworkedGap {
  int number = 0;  ///< of the gap in the coverage, from 1
  double area_m2 = 0;
  Point at;  ///< a point within the gap
  std::string why;
};

struct RepairPlan {
  Plan plan;                             ///< its body: the gaps to work; worked: the rest of the field
  int gaps = 0;                          ///< gaps of the coverage that lie in this field
  int worked_gaps = 0;                   ///< the number of them that are worked, fully or as far as it pays
  std::vector<UnworkedGap> ignored;      ///< smaller than the least area, the largest first
  std::vector<UnworkedGap> unreachable;  ///< no swath in a direction driven there fits in
  std::vector<UnworkedGap> not_worth;    ///< a pass over them costs more than it saves
  double missed_before_m2 = 0;           ///< all missed land, down to the thinnest sliver
  double missed_after_m2 = 0;            ///< the part of it that no swath of the plan covers
  double cost_if_left = 0;               ///< missed_before_m2 at the price of missed land
  /// Overlap, turns and stops of the plan, and a turn for the way to the first line.
  double cost_of_passes = 0;
  double cost_after = 0;  ///< cost of the passes and of missed_after_m2
};

/// Plans passes over the gaps of at least `min_area_m2`, as far as they save more than they cost:
/// chosen_lines() in the directions driven there (driven_directions.h). All other gaps are listed with the
/// reason.
///
/// `field`: outer ring and obstacles, `gaps`, `missed` and `driven` within it, all in its local metres.
/// Swaths stay in the field and out of obstacles, and run on over worked land as far as the end rule says;
/// between the pieces of one line the machine drives on with the work off. Prices are those of the objective;
/// see price_of() for short pieces. The machine's least length applies to lines, and its default is 0.
///
/// Throws kBadInput where there is no gap, none large enough, none that can be entered, or none that is worth
/// a pass. Deterministic for any number of threads, unless the progress wants an end (plan_field()).
RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       const std::vector<DrivenLine>& driven, RepairTerms terms, double min_area_m2,
                       int threads, const Progress& progress);

}  // namespace tramline
