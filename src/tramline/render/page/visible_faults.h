#pragma once

#include "tramline/geometry/polygon/region.h"

namespace tramline::render {

/// Twice the area over the length of the edges, m: about the width of a long thin polygon.
double mean_width(const Polygon& polygon);

/// The overlap or uncovered land worth drawing. Every fault is drawn at least a pixel wide, so a gap or
/// overlap of micrometres that rounding leaves between touching swaths would look real; faults thinner than a
/// millimetre are left out.
Region visible_faults(const Region& faults);

}  // namespace tramline::render
