#pragma once
// What is known of a cell: within the field or not, how often worked, repeated or not, or not recorded.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tramline/coverage/grid_point.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

using CellState = std::uint8_t;
inline constexpr std::size_t kCellStates = 16;

/// Ground that was never worked cannot be repeated: there the same bit says that it may have been worked and
/// was not recorded.
constexpr CellState cell_state(bool in_field, int times, bool repeated_or_unrecorded) {
  return static_cast<CellState>((in_field ? 1 : 0) | times << 1 | (repeated_or_unrecorded ? 8 : 0));
}
constexpr bool in_field(CellState state) { return (state & 1) != 0; }
constexpr int times_worked(CellState state) { return state >> 1 & 3; }
constexpr bool is_repeated(CellState state) { return (state & 8) != 0 && times_worked(state) > 0; }
constexpr bool is_unrecorded(CellState state) { return (state & 8) != 0 && times_worked(state) == 0; }

/// Of each state, the one that follows it.
using Transition = std::array<CellState, kCellStates>;
/// Worked once more; counted up to `most`.
Transition worked_again(int most);
/// Repeated, where it was worked before.
Transition made_repeated();
/// Not recorded, where it was not worked; `everywhere`: outside the field too.
Transition made_unrecorded(bool everywhere);

/// A set of states: bit s says whether state s is one of them.
using StateSet = std::uint16_t;
constexpr bool holds(StateSet set, CellState state) { return (set >> state & 1) != 0; }
StateSet states_of(Ground what);
/// States that `next` changes.
StateSet changed_by(const Transition& next);

/// Twice the areas of the ground in each state, square units. Sums are exact, so their order is nothing.
using Totals = std::array<Int128, kCellStates>;

}  // namespace tramline::coverage
