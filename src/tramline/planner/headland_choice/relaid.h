#pragma once
// The layout of one plan on another body of the same field.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Tracks in the directions and along the curves of the subfields of `layout`, on the ground of the task, at
/// the best offset for it. Where all subfields have one direction the ground is not divided. The subfields of
/// the layout cover the ground, but for slivers. O(a search for the best offset for each part).
SearchResult relaid(const PlanningProblem& problem, const PreparedField& prepared,
                    const std::vector<Subfield>& layout, const SearchContext& context);

}  // namespace tramline
