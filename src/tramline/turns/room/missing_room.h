#pragma once
// How far an outline leaves the land.

#include "tramline/turns/outline/outline.h"

namespace tramline {

/// The greatest distance from the land of a point on the sides of the outline's parts, on their way, m; at
/// least 0. See AllowedLand::missing_m(). Precondition: the land is not empty.
double missing_room_m(const Region& land, const SteeredPath& path, const Outline& outline);

}  // namespace tramline
