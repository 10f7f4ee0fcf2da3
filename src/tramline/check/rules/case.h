#pragma once
// A plan with what several rules need of it.

#include <optional>
#include <vector>

#include "tramline/check/lines/track_lines.h"
#include "tramline/check/measure/bounded_polygon.h"
#include "tramline/check/measure/worked_body.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// The swaths and the headland passes together, over body and headland ground.
struct WithPasses {
  Region land;
  std::vector<WorkedPart> parts;
  WorkedBody worked;
  double passes_m2 = 0;  ///< width · length of the passes, without what lies on passables
};

/// A plan with what several rules need of it. Refers to the plan, which has to outlive it.
struct Case {
  explicit Case(const Plan& of);

  const Plan& plan;
  BoundedRegion obstacles;  ///< those the machine may not enter
  BoundedRegion blocking;   ///< those of them that have no headland: a track that ends there has to back out
  BoundedRegion passables;
  BoundedRegion given_up;
  /// All that is nearer to the field's outer ring or to an obstacle than its headland is deep, whether it is
  /// land or not. Holes of obstacles with a headland are out of it.
  Region near_boundaries;
  double round_edges_m2 = 0;        ///< what chords may take from that, or add to it
  Region along_boundaries;          ///< the same with one pass for each boundary that has any
  std::vector<Box> obstacle_boxes;  ///< of all obstacles of the field, in their order
  double area_tolerance_m2;         ///< 1e-6 of the field's area, not below what the precision grid can do
  PlanLines lines;                  ///< of tracks that follow a curve
  std::vector<WorkedPart> parts;    ///< of the swaths
  WorkedBody worked;                ///< what they work of the body
  std::optional<WithPasses> with_passes;  ///< where figures count headland passes, too, and there are any
};

/// The land that the plan's figures are about, the parts of all swaths that they count, and what these work
/// of it.
const Region& counted_land(const Case& c);
const std::vector<WorkedPart>& counted_parts(const Case& c);
const WorkedBody& counted_work(const Case& c);

}  // namespace tramline::check
