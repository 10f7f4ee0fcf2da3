#pragma once
// What a search works on once headlands are taken off the field (S2.5).

#include "tramline/planner/candidate.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The task of a plan with the headlands its settings ask for: without any, search_task()'s. The field's own
/// boundary is hard then. Obstacles get their passes unless tracks go round them: those that every track goes
/// round which meets them, in a plan of the same strategy without their headlands. Under the end rule
/// `cover`, which leaves nothing, with curved tracks and where all tracks are to be cut, none is gone round.
/// Where the passes take the whole field there is no body, and so there are no tracks.
/// Throws kBadInput where not even one pass has room.
SearchTask headlanded_task(const Field& field, const Machine& machine, const Objective& objective,
                           const PlanSettings& settings, const SearchContext& context);

}  // namespace tramline
