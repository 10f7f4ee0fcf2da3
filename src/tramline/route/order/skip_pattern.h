#pragma once
// Orders in which no track is followed by one close to it.

#include <cstddef>
#include <vector>

namespace tramline::order {

/// The order of `tracks` tracks that lie side by side, each driven the other way than the one before, in
/// which every jump leads at least `jump` tracks away: 0, k, 1, k + 1, … by groups of 2·jump + 1 tracks and
/// more (Bochtis and Vougioukas 2008, who call it skip-and-fill). Where there are fewer tracks, jumps are as
/// long as half of them. Precondition: jump ≥ 1. O(n).
std::vector<std::size_t> skip_pattern(std::size_t tracks, std::size_t jump);

}  // namespace tramline::order
