#pragma once
// Shapes of a plan file without the vertices that nobody would miss.

#include <ogr_geometry.h>

#include <memory>

namespace tramline::io {

/// Lines and the rings of polygons as thinned() has them; points as they are. A polygon that would no longer
/// be a valid one (a sliver narrower than the tolerance) keeps all its vertices. The result moves by
/// `tolerance_m` at most, in the metres of the file. O(n log n) as a rule.
std::unique_ptr<OGRGeometry> thinned_shape(const OGRGeometry& shape, double tolerance_m);

}  // namespace tramline::io
