#pragma once
// What was decided where curved tracks meet obstacles, in the words of the plan.

#include <vector>

#include "tramline/planner/curved_family.h"
#include "tramline/planner/driven_tracks.h"

namespace tramline {

/// Sides are seen in driving direction, and the subfield is that of the piece of the track that is next to
/// the place. By subfield. O(encounters · pieces).
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const CurvedCandidate& candidate,
                                            const Driven& driven);

}  // namespace tramline
