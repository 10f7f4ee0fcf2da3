#pragma once
// What is wrong with a plan, which another kind of plan may do better.

#include "tramline/model/plan.h"
#include "tramline/planner/assembly/finished_plan.h"

namespace tramline {

/// Whether its route backs out of or into tracks. O(legs), as all that follow.
bool backs_out_of_tracks(const Plan& plan);

/// Whether a route has more legs without room than it takes to go from each part of the land to the next.
bool leaves_land(const PlanDraft& draft);

/// Whether a route leaves the land, or backs out of or into every fourth track.
bool lacks_room(const PlanDraft& draft);

/// Whether it has so few tracks that it depends on where these lie what their turns and ways come to.
bool has_few_tracks(const Plan& plan);

/// Whether it has few tracks, and land left, stops and legs without room are most of its whole cost.
bool hardly_works(const Plan& plan);

/// The same of a plan of next to no tracks: the field is hardly larger than its headlands.
bool hardly_works_any_track(const Plan& plan);

}  // namespace tramline
