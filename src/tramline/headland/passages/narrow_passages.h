#pragma once
// Passes through narrow passages: land where a pass has room on both sides but the machine cannot turn.

#include <functional>
#include <vector>

#include "tramline/headland/turning_room.h"

namespace tramline {

/// Whether driving rings is better than driving others (are_better()).
using BetterRings =
    std::function<bool(const std::vector<OffsetRing>& rings, const std::vector<OffsetRing>& than)>;

/// Rings of turning_centres(land) that also lead through narrow passages, where that is better. The circle
/// needs no room in a passage: it rolls along one side, however near the other is; only what it draws has to
/// be on the land. One by one, rings that face one another across a passage, or a ring that faces itself
/// (round an obstacle), are joined by a line along each side; so are those that meet where several passages
/// meet. Where the path cannot be driven, or would cross itself or another one more often, the passage is
/// left out. Beside several boundaries, offset lines along which nothing is driven may become rings, too.
/// (Beside a single boundary there are none: a closed path without an obstacle inside has room for the circle
/// that it is nowhere tighter than; Pestov and Ionin 1959.)
///
/// O(n²) for n pieces of the offset line, and one comparison for each passage.
std::vector<OffsetRing> joined_through_narrow_passages(std::vector<OffsetRing> centres,
                                                       const TurningRoom& land, const BetterRings& better);

}  // namespace tramline
