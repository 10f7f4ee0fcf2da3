#pragma once
// Thins shapes of a plan file.

#include <ogr_geometry.h>

#include <memory>

namespace tramline::io {

/// Lines and the rings of polygons are thinned(); points are kept. A polygon that would no longer be valid (a
/// sliver narrower than the tolerance) keeps all its vertices. The result moves by `tolerance_m` at most, in
/// the metres of the file. O(n log n) as a rule.
std::unique_ptr<OGRGeometry> thinned_shape(const OGRGeometry& shape, double tolerance_m);

}  // namespace tramline::io
