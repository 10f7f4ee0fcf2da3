#pragma once
// How much of a swath's cross-section lies on a piece of land, along the whole swath.

#include <vector>

#include "tramline/check/measure/piece_frame.h"
#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// A stretch of a path, m from its start.
struct Stretch {
  double from_m = 0;
  double to_m = 0;
  double least_m = 0;  ///< least length of cross-section inside, on the stretch

  double length() const { return to_m - from_m; }
};

/// The longest stretch of a path of lines and arcs on which the cross-section of half width `half_m` has less
/// than `required_m` metres inside the land: in an odd number of its rings. Stretches may go on from one
/// segment to the next. Along straight segments it is exact: the length inside is linear between the places
/// where the land's edges meet the swath, and is looked at between all of them. About arcs cross-sections
/// stand like the spokes of a wheel; there the length inside is looked at in eight places between those where
/// an edge of the land meets the swath, its sides, or its foot from the arc's centre, and where that falls
/// below what is required, by bisection. Zero length where there is none. O(v·k) for v vertices of the land,
/// k of them within the swath.
Stretch longest_below(const Polygon& land, const Path& path, double half_m, double required_m);

/// Joins stretches that touch and keeps the longest. They come in their order along the piece.
class LongestStretch {
 public:
  void add(const Stretch& stretch);
  Stretch best() const { return best_; }

 private:
  Stretch current_;
  Stretch best_;
};

/// The stretches of one straight segment, which begins `begin_m` along its path.
void add_along_straight(const Polygon& land, const PieceFrame& frame, double half_m, double required_m,
                        double begin_m, LongestStretch& out);

}  // namespace tramline::check
