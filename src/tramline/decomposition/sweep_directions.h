#pragma once
// The directions that a sweep tries where a field has too many edges to try them all.

#include <vector>

#include "tramline/decomposition/candidate_directions.h"

namespace tramline {

/// Largest number of directions of which a sweep tries all; Versleijen's fields have 69 at most.
inline constexpr std::size_t kMostSweepDirections = 256;
/// Of more directions, which are chords of curved edges, no two are tried that are nearer than 180 degrees /
/// this.
inline constexpr std::size_t kThinnedDirections = 128;

/// The directions of candidate_directions(), or, if these are more than kMostSweepDirections, those along the
/// longest edges, thinned. In increasing order. O(n log n), if thinned O(n·kThinnedDirections).
std::vector<Direction> sweep_directions(const Field& field);

}  // namespace tramline
