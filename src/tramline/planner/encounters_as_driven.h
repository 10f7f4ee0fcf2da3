#pragma once
// Encounters in the words of the finished plan.

#include <vector>

#include "tramline/planner/candidate.h"

namespace tramline {

/// The encounters of a candidate with its tracks numbered as in `pieces`, and left and right seen in the
/// direction in which the track is driven there (in that of the subfield where it is not driven).
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const std::vector<TrackPiece>& pieces);

}  // namespace tramline
