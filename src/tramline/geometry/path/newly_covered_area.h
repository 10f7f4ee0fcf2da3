#pragma once
// How much of the body a set of shapes newly covers: exact areas between straight lines and arcs,
// without chords and without building the intersection.

#include <cstdint>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// What a shape says of the ground inside it: it is to be covered, it has been, it would be now.
enum class Layer : std::uint8_t { kBody, kTaken, kNew };

/// A stretch of a shape's boundary along which y rises: a straight line, or part of an arc.
struct RisingCurve {
  Point from;
  Point to;              ///< from.y < to.y, and y turns nowhere in between
  double curvature = 0;  ///< 1/m, for from → to, as that of a PathSegment
  Layer layer = Layer::kBody;
  int change = 0;  ///< what crossing it towards growing x adds to the layer's winding number

  friend bool operator==(const RisingCurve& a, const RisingCurve& b) = default;
};

/// Boundaries of any number of shapes, in no order. A point is inside a layer where the changes of the
/// layer's curves to the left of it sum to more than 0.
using RisingCurves = std::vector<RisingCurve>;

/// Adds what of a ring matters within the window: edges are cut at the window's y range. Left of the
/// window only the winding number matters, so each chain of edges there becomes one vertical line 1 m
/// left of it; edges wholly right of the window are left out.
/// Counter-clockwise rings add 1 inside, clockwise ones (holes) take 1 away. O(n).
void append_ring(const Ring& ring, Layer layer, const Box& window, RisingCurves& out);

/// Adds an axis-parallel rectangle, as append_ring would do with its corners taken counter-clockwise.
void append_box(const Box& box, Layer layer, const Box& window, RisingCurves& out);

/// Adds the ground within half the width on both sides of a path, with flat ends: the shape that band()
/// has with chords for arcs. Any path will do; none of its curves is left out or cut.
/// Precondition: tangents are continuous and radii at least half the width (up to rounding). O(n).
void append_band(const Path& path, double width_m, Layer layer, RisingCurves& out);

/// Area of the points inside the body, not inside the taken layer and inside the new one, m². Closed
/// form: exact up to rounding, about 1e-16 of the squared size of the new ground per curve and crossing;
/// curves that touch, coincide or all but coincide cost no more than that. Arcs that are half a circle
/// to within d times their length know their centre, and so their area, to √d only.
/// Precondition: rings were added for windows that contain all new ground.
/// O(n log n + n·a + k·a) for n curves, a of them at one height, that cross k times.
double newly_covered_area(const RisingCurves& curves);

}  // namespace tramline
