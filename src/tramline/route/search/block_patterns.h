#pragma once
// Orders of the tracks of a block that lie side by side.

#include <cstddef>
#include <vector>

namespace tramline::order {

/// The order of `tracks` tracks by lands of `land` tracks: each land from both sides inwards, first one side,
/// then the other, so that jumps grow shorter; a last land takes what remains. Precondition: land ≥ 1. O(n).
std::vector<std::size_t> land_pattern(std::size_t tracks, std::size_t land);

/// Orders of `tracks` neighbouring tracks worth comparing where the machine turns best to a track `best_jump`
/// away: up and down, skip_pattern() of that jump and its neighbours, lands as wide that their jumps are near
/// it, and one land. No order twice. Precondition: best_jump ≥ 1. O(n).
std::vector<std::vector<std::size_t>> block_patterns(std::size_t tracks, std::size_t best_jump);

}  // namespace tramline::order
