#pragma once
// The layout of one plan on another body of the same field.

#include "tramline/model/plan.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Where straight tracks lie across their direction: as in the layout, or where they cost least on the
/// ground.
enum class Offset { kOfLayout, kBest };

/// Tracks in the directions and along the curves of the subfields of `layout`, on the ground that headlands
/// leave. Where all subfields have one direction the ground is not divided. The subfields of the layout cover
/// the ground, but for slivers; those without pieces have the best offset. Precondition: the layout has a
/// subfield. O(laying the tracks), or of a search for the best offset for each part.
SearchResult relaid(const PlanningProblem& problem, const PreparedField& prepared, const Plan& layout,
                    Offset offset, const SearchContext& context);

}  // namespace tramline
