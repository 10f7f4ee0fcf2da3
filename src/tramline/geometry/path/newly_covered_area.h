#pragma once
// The part of the body that a set of shapes newly covers: exact areas between straight lines and arcs,
// without chords and without building the intersection.

#include <cstdint>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The meaning of a shape for the land inside it: it is to be covered, it has been covered, it would be
/// covered now.
enum class Layer : std::uint8_t { kBody, kCovered, kNew };

/// A stretch of a shape's boundary along which y rises: a straight line, or part of an arc.
struct RisingCurve {
  Point from;
  Point to;              ///< from.y < to.y, and y turns nowhere in between
  double curvature = 0;  ///< 1/m, for from → to, as that of a PathSegment
  Layer layer = Layer::kBody;
  int change = 0;  ///< change of the layer's winding number on crossing the curve towards growing x

  friend bool operator==(const RisingCurve& a, const RisingCurve& b) = default;
};

/// Boundaries of any number of shapes, in no order. A point is inside a layer where the changes of the
/// layer's curves to the left of it sum to more than 0.
using RisingCurves = std::vector<RisingCurve>;

/// Adds the parts of a ring that matter within the window: edges are cut at the window's y range. Left of the
/// window only the winding number matters, so each chain of edges there becomes one vertical line 1 m left of
/// it; edges wholly right of the window are left out. Counter-clockwise rings add 1 inside, clockwise ones
/// (holes) take 1 away. O(n).
void append_ring(const Ring& ring, Layer layer, const Box& window, RisingCurves& out);

/// Adds an axis-parallel rectangle, as append_ring would do with its corners taken counter-clockwise.
void append_box(const Box& box, Layer layer, const Box& window, RisingCurves& out);

/// Adds the area within half the width on both sides of a path, with flat ends: the shape that band()
/// approximates with chords. Any path is accepted; none of its curves is left out or cut. Precondition:
/// tangents are continuous and radii at least half the width (up to rounding). O(n).
void append_band(const Path& path, double width_m, Layer layer, RisingCurves& out);

/// Adds the area of a swath along a path: append_band() or, where the path has kinks, its kinked_cells().
void append_swath_area(const Path& path, double width_m, Layer layer, RisingCurves& out);

/// Area of the points inside kBody, not inside kCovered and inside kNew, m². Closed form: exact up to
/// rounding, about 1e-16 of the squared size of the new area per curve and crossing; curves that touch,
/// coincide or nearly coincide lose no more than that. The centre, and so the area, of an arc that is half a
/// circle to within d times its length is known to √d only. Precondition: rings were added for windows that
/// contain the whole new layer. O(n log n + n·a + k·a) for n curves, a of them at one height, that cross k
/// times.
double newly_covered_area(const RisingCurves& curves);

}  // namespace tramline
