#pragma once
// The tracks of a layout behind given headlands, in so far as they decide whether these headlands are better
// than others.

#include <optional>

#include "tramline/model/plan.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/headland_choice/passes_by_boundary.h"
#include "tramline/planner/headland_choice/relaid.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/prepared_field.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

struct HeadlandTrial {
  PassesByBoundary passes;
  PlanningProblem problem;  ///< with these passes
  PreparedField prepared;
  SearchResult found;
  PlanDraft draft;
};

/// The laid piece of a piece of its draft. O(1).
const LaidPiece& laid_piece(const HeadlandTrial& trial, std::size_t piece);

/// The passes with what the settings decide instead of the turns.
PassesByBoundary as_set(const PlanningProblem& problem, PassesByBoundary passes);

/// The problem with these passes along the edges of the field.
PlanningProblem problem_with(const PlanningProblem& problem, const PassesByBoundary& passes);

/// The layout laid anew behind the passes (relaid()). nullopt where they leave no track.
std::optional<HeadlandTrial> headland_trial(const PlanningProblem& problem, const Plan& layout,
                                            const PassesByBoundary& passes, Offset offset,
                                            const SearchContext& context);

/// The same on a field that is prepared with these passes already.
std::optional<HeadlandTrial> headland_trial_on(PlanningProblem problem, PreparedField prepared,
                                               const Plan& layout, const PassesByBoundary& passes,
                                               Offset offset, const SearchContext& context);

/// The trial with its turns or its route planned anew as `turns` says, where it has others.
HeadlandTrial drafted_with(HeadlandTrial trial, TurnPlanning turns);

/// The trial as a plan.
Plan finished(HeadlandTrial trial, const SearchContext& context);

}  // namespace tramline
