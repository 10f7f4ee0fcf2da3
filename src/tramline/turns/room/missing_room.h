#pragma once
// How far an outline leaves the land.

#include "tramline/turns/outline/outline.h"

namespace tramline {

/// The greatest distance from the land of a point on the sides of the outline's parts, on their way, m; at
/// least 0; infinite where there is no land. Where it is `enough_m` or more, the answer may be less than it,
/// but is `enough_m` at least; and it may be too little by the share `roughly` of it. See
/// AllowedLand::missing_m().
double missing_room_m(const Region& land, const SteeredPath& path, const Outline& outline, double enough_m,
                      double roughly);

}  // namespace tramline
