#pragma once
// What a user asks of a machine's turns.

#include <optional>

#include "tramline/turns/turn_table.h"

namespace tramline::app {

/// The tracks and the border; `spacing_m` unset: 1 to 8 working widths. Throws bad_input for a machine that
/// has no radius to turn on, and for a spacing or a border that there is not.
TurnTableSettings turns_asked(const Machine& machine, std::optional<double> spacing_m, double border_deg);

}  // namespace tramline::app
