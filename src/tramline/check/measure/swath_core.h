#pragma once
// The ground that the swath along a path works for certain, and how much land of some kind that is.

#include <optional>
#include <vector>

#include "tramline/check/measure/bounded_polygon.h"
#include "tramline/check/measure/piece_frame.h"
#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// The swath along a path, a millimetre less on all sides: what only touches a swath is not in it. Along one
/// straight segment areas are clipped exactly; else they are those of polygons, whose chords are within the
/// millimetre. Empty where nothing is left.
class SwathCore {
 public:
  SwathCore(const Path& path, double width_m);

  bool empty() const { return !rectangle_ && bands_.empty(); }
  /// What of some land lies in it; `at` on the largest part. O(v) for v vertices of land near by along a
  /// straight line, else an overlay for each segment there.
  Clipped part_on(const BoundedRegion& land) const;
  /// What of it lies outside a ring, nothing where that is rounding. O(v).
  Clipped part_beyond(const Ring& outer) const;
  /// Land thinner than the precision grid along a whole straight core is no land, m². Overlays, which are
  /// made on that grid, have none.
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
