#pragma once
// Orders by lands.

#include <cstddef>
#include <vector>

namespace tramline::order {

/// The order of `tracks` tracks by lands of `land` tracks: each land from both sides inwards, first one side,
/// then the other, so that jumps grow shorter; a last land takes what remains. Precondition: land ≥ 1. O(n).
std::vector<std::size_t> land_pattern(std::size_t tracks, std::size_t land);

}  // namespace tramline::order
