#pragma once
// Where a route begins or ends: at a gate.

#include <optional>

#include "tramline/route/connection/driving_ground.h"

namespace tramline {

/// The gate, or the place nearest to it at which the outline has room in some heading: a gate lies on the
/// edge of the field, where none has. Looked for up to kMostBesideGate_m away; the gate itself where there is
/// none.
std::optional<Point> with_room(const std::optional<Point>& gate, const DrivingGround& ground);

inline constexpr double kMostBesideGate_m = 100;

}  // namespace tramline
