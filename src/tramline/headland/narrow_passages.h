#pragma once
// Passes through necks: land where a pass has room on both sides, but the machine none to turn.

#include <functional>
#include <vector>

#include "tramline/headland/turning_room.h"

namespace tramline {

/// How bad it is to drive rings: where they meet first of all, then what they leave and double.
struct RingsCost {
  int meetings = 0;
  double missed_and_doubled_m2 = 0;  ///< what they leave kMissedToDoubled times; up to a constant
};
using CostOfRings = std::function<RingsCost(const std::vector<OffsetRing>&)>;

/// Rings of turning_centres(land) that also pass necks, where that costs less. The circle needs no room in a
/// neck: it rolls along one side, however near the other is, and what it draws has to be on the land. One by
/// one, rings that face one another across a neck, or a ring that faces itself (round an obstacle), are
/// joined by a way along each side; so are those that meet where several necks do. Where the path cannot be
/// driven, or would cross itself or another one more often, the neck is left out. Beside several boundaries,
/// levels along which nothing is driven may become rings, too. (Beside one there are no such: inside a closed
/// path without an obstacle there is room for the circle that it is nowhere tighter than; Pestov and Ionin
/// 1959.)
///
/// O(n²) for n pieces of the level, and the cost once for each neck.
std::vector<OffsetRing> joined_through_narrow_passages(std::vector<OffsetRing> centres,
                                                       const TurningRoom& land, const CostOfRings& cost);

}  // namespace tramline
