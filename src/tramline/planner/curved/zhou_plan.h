#pragma once
// Plans with Zhou's own construction of tracks.

#include "tramline/planner/curved/best_curved.h"

namespace tramline {

/// Throws kBadInput where an obstacle is to have no headland, or is passable: Zhou requires a headland round
/// every obstacle for rows to end in.
void require_zhou_ground(const Field& field, const PlanSettings& settings);

/// The tracks that Zhou makes along the line (zhou_tracks.h), as a candidate for finished_plan(): the
/// reference is the line, extended across the land and not smoothed. Precondition: require_zhou_ground(), so
/// that nothing hard remains on the task's land.
Candidate zhou_plan_along(const SearchTask& task, const std::vector<Point>& line);

/// The same along the chain of edges that best_curved() follows; nullopt where it finds none.
std::optional<Candidate> zhou_plan_along_best(const SearchTask& task, const SearchContext& context);

}  // namespace tramline
