#pragma once
// How much of a swath's cross-section lies on a piece of land, along the whole swath.

#include <vector>

#include "tramline/check/piece_frame.h"

namespace tramline::check {

/// A stretch of a piece, m from its start.
struct Stretch {
  double from_m = 0;
  double to_m = 0;
  double least_m = 0;  ///< least length of cross-section inside, on the stretch

  double length() const { return to_m - from_m; }
};

/// The longest stretch of the piece on which the cross-section of half width `half_m` has less than
/// `required_m` metres inside the land. Exact: the length inside is linear between the places where
/// the land's edges meet the swath, and is looked at between all of them. Zero length where there is
/// none. O(v·k) for v vertices of the land, k of them within the swath.
Stretch longest_below(const Polygon& land, const PieceFrame& frame, double half_m, double required_m);

}  // namespace tramline::check
