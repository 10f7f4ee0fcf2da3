#pragma once
// The directions a sweep tries where a field has more edges than a sweep has time.

#include <vector>

#include "tramline/decomposition/candidate_directions.h"

namespace tramline {

/// Of so many directions a sweep tries all; S1's fields have 69 at most.
inline constexpr std::size_t kMostSweepDirections = 256;
/// Of more, which are chords of curved edges, no two are tried that are nearer than 180 degrees / this.
inline constexpr std::size_t kThinnedDirections = 128;

/// candidate_directions(), or of more than kMostSweepDirections those along the longest edges, thinned. In
/// increasing order. O(n log n), of more O(n·kThinnedDirections).
std::vector<Direction> sweep_directions(const Field& field);

}  // namespace tramline
