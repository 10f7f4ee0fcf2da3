#pragma once
// The land that the swath along a path works for certain, and its overlap with other land.

#include <optional>
#include <vector>

#include "tramline/check/measure/bounded_polygon.h"
#include "tramline/check/measure/piece_frame.h"
#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// The swath along a path, a millimetre less on all sides: what only touches a swath is not in it. Along a
/// single straight segment areas are clipped exactly; otherwise they are those of polygons, whose chords are
/// within the millimetre. Empty where nothing remains.
class SwathCore {
 public:
  SwathCore(const Path& path, double width_m);

  bool empty() const { return !rectangle_ && bands_.empty(); }
  /// The part of some land that lies in it; `at` is on the largest part. O(v) for v vertices of land near by
  /// along a straight line, else an overlay for each segment there.
  Clipped part_on(const BoundedRegion& land) const;
  /// The part of it outside a ring; empty where that is only rounding. O(v).
  Clipped part_beyond(const Ring& outer) const;
  /// The area below which land in a straight core does not count, m²: a sliver thinner than the precision
  /// grid along the whole core. Overlays, which are made on that grid, have no such slivers.
  double slivers_m2() const;

 private:
  /// Exact, in a frame of its own.
  struct Rectangle {
    PieceFrame frame;
    Box box;

    double area_m2() const { return box.width() * box.height(); }
    Clipped part_beyond(const Ring& outer) const;
  };

  std::optional<Rectangle> rectangle_;
  Region bands_;
  std::vector<Box> boxes_;  ///< of the bands
};

}  // namespace tramline::check
