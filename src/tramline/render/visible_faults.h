#pragma once

#include "tramline/geometry/region.h"

namespace tramline::render {

/// The overlap or uncovered land worth drawing. Every fault is drawn at least a pixel wide, so what
/// rounding leaves between two swaths that only touch, micrometres wide, would look like real overlap:
/// polygons thinner than a millimetre on average are left out.
Region visible_faults(const Region& faults);

}  // namespace tramline::render
