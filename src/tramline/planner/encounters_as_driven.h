#pragma once
// Encounters in the words of the finished plan.

#include <vector>

#include "tramline/planner/candidate.h"

namespace tramline {

/// The encounters of a candidate with its tracks numbered as in `pieces`, and left and right seen in the
/// direction in which the piece of its track next to it is driven, of two as near the one driven first (in
/// that of the subfield where the track is not driven). Precondition: `pieces` in driving order.
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const std::vector<TrackPiece>& pieces);

}  // namespace tramline
