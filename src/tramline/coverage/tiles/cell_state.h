#pragma once
// The state of a cell: within the field or not, how often worked, repeated or not, or not recorded.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tramline/coverage/tiles/grid_point.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// The lowest bit says that the cell is in the field, the next two how often it was worked, the highest that
/// it is repeated. Land that was never worked cannot be repeated: there the highest bit says that it may have
/// been worked and was not recorded.
using CellState = std::uint8_t;
inline constexpr std::size_t kCellStates = 16;

/// The initial states of cells outside the field and in it.
inline constexpr CellState kUnworkedOutside = 0;
inline constexpr CellState kUnworkedField = 1;
constexpr bool in_field(CellState state) { return (state & 1) != 0; }
constexpr int times_worked(CellState state) { return state >> 1 & 3; }
constexpr bool is_repeated(CellState state) { return (state & 8) != 0 && times_worked(state) > 0; }
constexpr bool is_unrecorded(CellState state) { return (state & 8) != 0 && times_worked(state) == 0; }

/// The next state for each state.
using Transition = std::array<CellState, kCellStates>;
/// Worked once more, counted up to `most`.
Transition worked_again(int most);
/// Repeated where it was worked before.
Transition made_repeated();
/// Not recorded where it was not worked.
Transition made_unrecorded();
/// The same, without changes outside the field.
Transition made_unrecorded_in_field();

/// A set of states: bit s says whether state s is one of them.
using StateSet = std::uint16_t;
constexpr bool holds(StateSet set, CellState state) { return (set >> state & 1) != 0; }
StateSet states_of(LandClass what);
/// The states that `next` changes.
StateSet changed_by(const Transition& next);

/// Twice the area in each state, square units. Sums are exact, so their order does not matter.
using Totals = std::array<Int128, kCellStates>;

}  // namespace tramline::coverage
