#pragma once
// Renumbers encounters for the finished plan and turns their sides into driving direction.

#include <vector>

#include "tramline/planner/assembly/driven_tracks.h"

namespace tramline {

/// The encounters of a candidate, with tracks numbered as in the driven pieces. Left and right are those of
/// the driving direction of the nearest piece of the encounter's track, of two equally near the one driven
/// first; where the track is not driven, those of the track's direction. Where
/// tracks are left out that are not worth the way, ways past obstacles that would be cheaper than those
/// chosen are refused for it. O(encounters · pieces).
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const Driven& driven);

}  // namespace tramline
