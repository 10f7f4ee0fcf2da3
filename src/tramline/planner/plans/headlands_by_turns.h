#pragma once
// Plans whose headlands follow from the turns of their tracks, by the cost of the tracks.

#include <optional>

#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/plans/searched_plan.h"

namespace tramline {

/// Whether headlands round the field or round obstacles are to be as deep as turns need.
bool headlands_follow_turns(const PlanSettings& settings);

/// The problem without the headlands that are to follow from the turns of its plan, which has none.
PlanningProblem without_headlands_for_turns(PlanningProblem problem);

/// The plan where the headlands that were asked for leave no room for tracks: there is nothing for turns to
/// decide.
ExplainedPlan planned_without_tracks(const PlanningProblem& problem, const SearchContext& context);

/// The headlands that the turns between the tracks of this layout need.
HeadlandTrial with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                                       const SearchContext& context);

/// The layout of least cost of its tracks on the bare field, with the headlands that its turns need; nullopt
/// where it has no tracks. Offsets behind these headlands are found near enough (near_enough()). Throws as
/// searched_plan(). Precondition: headlands follow turns.
std::optional<HeadlandTrial> best_tracks_with_headlands_for_turns(const PlanningProblem& problem,
                                                                  const SearchContext& context);

/// What decides between the headlands that the turns of a layout need, where tracks end, and others.
enum class Decides { kCostOfTracks, kWholeCost };

/// The same as a plan, with or without tracks.
ExplainedPlan planned_with_headlands_for_turns(const PlanningProblem& problem, Decides decides,
                                               const SearchContext& context);

}  // namespace tramline
