#pragma once
// What is known of a cell: within the field or not, how often worked, repeated or not, or not recorded.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tramline/coverage/tiles/grid_point.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// The lowest bit says that the cell is in the field, the next two how often it was worked, the highest that
/// it is repeated. Ground that was never worked cannot be repeated: there the highest bit says that it may
/// have been worked and was not recorded.
using CellState = std::uint8_t;
inline constexpr std::size_t kCellStates = 16;

/// As cells begin: outside the field, and in it.
inline constexpr CellState kUnworkedOutside = 0;
inline constexpr CellState kUnworkedField = 1;
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
/// Not recorded, where it was not worked.
Transition made_unrecorded();
/// The same, and nothing changes outside the field.
Transition made_unrecorded_in_field();

/// A set of states: bit s says whether state s is one of them.
using StateSet = std::uint16_t;
constexpr bool holds(StateSet set, CellState state) { return (set >> state & 1) != 0; }
StateSet states_of(Ground what);
/// States that `next` changes.
StateSet changed_by(const Transition& next);

/// Twice the areas of the ground in each state, square units. Sums are exact, so their order is nothing.
using Totals = std::array<Int128, kCellStates>;

}  // namespace tramline::coverage
