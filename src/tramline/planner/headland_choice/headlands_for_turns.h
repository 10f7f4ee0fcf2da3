#pragma once
// Headlands as deep as the turns of the machine need, where tracks end, and nowhere else.

#include <functional>
#include <optional>

#include "tramline/model/plan.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// A layout in the directions that are best where this number of passes goes all round the field, or fewer
/// where these leave no room for tracks; nothing where even one leaves none.
using OtherLayout = std::function<std::optional<Plan>(int passes)>;

/// The layout of `layout`, a plan of the same problem without the headlands to be chosen, behind the
/// headlands that its turns need; finished() makes it a plan. Its directions, curves and subfields are kept,
/// and the tracks are laid anew on the body that the headlands leave. Passes begin as those that the turns of
/// the layout need (needed_passes()); where turns still leave the land, more are added, a few times. Where
/// the field has no room for all of them, the plan with the fewest turns without room is taken; its turns say
/// how much room is missing. Obstacles whose headlands are to be chosen get them where that costs less than
/// cutting tracks at them or driving round. Where many turns have no room, as where a long field would be
/// driven crosswise from edge to edge, the other layout is tried too: a turn without room costs what two
/// stops do. Throws as drafted().
HeadlandTrial trial_with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                                             const OtherLayout& behind_passes, const SearchContext& context);

}  // namespace tramline
