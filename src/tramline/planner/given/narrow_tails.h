#pragma once
// The narrow tails of land: what others leave when they cut it, and arms of fields.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The parts of a polygon that are narrower than `narrow_m` and longer than `long_m`: what a disc that wide
/// does not reach, corners left out. The edges where they leave the rest run across them. O(n log n).
Region narrow_tails(const Polygon& polygon, double narrow_m, double long_m);

}  // namespace tramline
