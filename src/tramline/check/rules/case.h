#pragma once
// A plan with data derived from it that several rules need.

#include <optional>
#include <vector>

#include "tramline/check/lines/track_lines.h"
#include "tramline/check/measure/bounded_polygon.h"
#include "tramline/check/measure/worked_land.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// The swaths and the headland passes together, on the body and the land of headlands.
struct WithPasses {
  Region land;
  std::vector<WorkedPart> parts;
  WorkedLand worked;
  double passes_m2 = 0;  ///< width · length of the passes, without their parts on passables
};

/// A plan with data derived from it that several rules need. Refers to the plan, which has to outlive it.
struct Case {
  explicit Case(const Plan& of);

  const Plan& plan;
  BoundedRegion obstacles;  ///< those the machine may not enter
  BoundedRegion blocking;   ///< those of them without a headland: a track that ends there has to back out
  BoundedRegion passables;
  BoundedRegion given_up;
  /// All that is nearer to the field's outer ring or to an obstacle than its headland is deep, whether it is
  /// land or not. Holes of obstacles with a headland are excluded.
  Region near_boundaries;
  double round_edges_m2 = 0;  ///< possible difference of near_boundaries due to chords
  Region along_boundaries;    ///< the same as near_boundaries with one pass for each boundary that has any
  std::vector<Box> obstacle_boxes;  ///< of all obstacles of the field, in their order
  double area_tolerance_m2;  ///< 1e-6 of the field's area, but not less than the effect of the precision grid
  PlanLines lines;           ///< of tracks that follow a curve
  std::vector<WorkedPart> parts;          ///< of the swaths
  WorkedLand worked;                      ///< areas of the body that the parts work
  std::optional<WithPasses> with_passes;  ///< where figures count headland passes, too, and there are any
};

/// The land that the plan's figures refer to, the parts of all swaths that they count, and the areas of that
/// land that these work.
const Region& counted_land(const Case& c);
const std::vector<WorkedPart>& counted_parts(const Case& c);
const WorkedLand& counted_work(const Case& c);

}  // namespace tramline::check
