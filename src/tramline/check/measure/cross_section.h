#pragma once
// The length of a swath's cross-section on a polygon of land, along the whole swath.

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
/// than `required_m` metres inside the land, that is, within an odd number of its rings. Stretches may go on
/// from one segment to the next. Along straight segments it is exact: the length inside is linear between the
/// positions where the land's edges cross the swath, and is evaluated between all of them. About arcs
/// cross-sections are like the spokes of a wheel; there the length inside is evaluated at eight positions
/// between those where an edge of the land crosses the swath or its sides or has its foot from the arc's
/// centre, and where it falls below what is required, the limit is found by bisection. Zero length where
/// there is none. O(v·k) for v vertices of the land, k of them within the swath.
Stretch longest_below(const Polygon& land, const Path& path, double half_m, double required_m);

/// Joins stretches that touch and keeps the longest. They are added in their order along the piece.
class LongestStretch {
 public:
  void add(const Stretch& stretch);
  Stretch best() const { return best_; }

 private:
  Stretch current_;
  Stretch best_;
};

/// Adds the stretches of one straight segment, which begins `begin_m` along its path.
void add_along_straight(const Polygon& land, const PieceFrame& frame, double half_m, double required_m,
                        double begin_m, LongestStretch& out);

}  // namespace tramline::check
