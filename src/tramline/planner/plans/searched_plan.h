#pragma once
// The plan that a search finds behind headlands of given depths.

#include "tramline/planner/plan_field.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"

namespace tramline {

enum class Explain { kNo, kYes };

/// The problem with tracks of this shape. Zhou's own construction is for curved ones.
PlanningProblem with_shape(PlanningProblem problem, TrackShape shape);

/// Straight or curved tracks, or the cheaper of both, along a given line, in given parts of the land, or of
/// all that the strategy looks at. Throws Error(kBadInput) where the headlands leave no room, no track fits,
/// no edge is a curve that tracks could follow, or the settings ask for tracks as in the paper without a
/// line.
ExplainedPlan searched_plan(const PlanningProblem& problem, const SearchContext& context, Explain explain);

}  // namespace tramline
