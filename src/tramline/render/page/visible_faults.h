#pragma once

#include "tramline/geometry/polygon/region.h"

namespace tramline::render {

/// Twice the area over the length of its edges, m: of a long thin polygon, about its width.
double mean_width(const Polygon& polygon);

/// The overlap or uncovered land worth drawing. Every fault is drawn at least a pixel wide, so what
/// rounding leaves between two swaths that only touch, micrometres wide, would look like real overlap:
/// what is thinner than a millimetre is left out.
Region visible_faults(const Region& faults);

}  // namespace tramline::render
