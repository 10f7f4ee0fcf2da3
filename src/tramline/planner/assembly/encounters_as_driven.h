#pragma once
// Encounters in the words of the finished plan.

#include <vector>

#include "tramline/planner/assembly/driven_tracks.h"

namespace tramline {

/// The encounters of a candidate with its tracks numbered as in the driven pieces, and left and right seen in
/// the direction in which the piece of its track next to it is driven, of two as near the one driven first
/// (in that of the track where it is not driven). O(encounters · pieces).
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const Driven& driven);

}  // namespace tramline
