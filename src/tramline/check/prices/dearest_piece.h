#pragma once
// Whether any piece is worth more than its turn.

#include <optional>
#include <vector>

#include "tramline/check/prices/priced_ground.h"
#include "tramline/geometry/angle.h"

namespace tramline::check {

/// Pieces of which it cannot be shown that they are worth no more than their turn.
struct DearPiece {
  Point at;  ///< on their middle line, local metres
  Direction direction;
  double worth = 0;  ///< at most
};

/// Pieces about which that can be shown of none are excluded: nullopt. Looks at all directions and offsets by
/// halves, the wider first, until what lies near a piece is worth no more than a turn. O(r³/w³) for land of
/// radius r where that is soon so; 64 times as long where a piece is worth a turn almost exactly.
std::optional<DearPiece> dear_piece(const Plan& plan, const PricedLand& land);

}  // namespace tramline::check
