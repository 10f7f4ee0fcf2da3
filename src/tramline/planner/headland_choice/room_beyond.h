#pragma once
// The room that turns need outside a field.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline {

/// By edge of the outer ring: how far the outline gets beyond the edge's line in the turns at whose ends the
/// edge lies, m; 0 for edges at which no track ends. Turns as planned. O(turns · n).
std::vector<double> room_beyond_edges(const Plan& plan);

}  // namespace tramline
