#pragma once
// Plans whose tracks run parallel to a curve (S2.11-S2.13).

#include <optional>

#include "tramline/planner/curved_family.h"

namespace tramline {

/// The cheapest family along a chain of boundary edges between two corners of the ground, at several levels
/// of smoothing, the best of them moved sideways as well; detours are looked for in the cheapest of these,
/// and in those that would be if a stop cost no more than a turn. nullopt where no chain is curved, or none
/// has a track. Deterministic for any number of threads. O(chains) families.
/// With S2's tracks to be made from the line chosen, which has to have ends, chains all the way round are
/// left out, and detours are not looked for.
std::optional<CurvedCandidate> best_curved(const SearchTask& task, int threads);

/// As a plan: tracks numbered from the reference, driven up and down one after another. Throws kBadInput
/// where it has no piece.
Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate);

}  // namespace tramline
