#pragma once
// Headland passes along whole sides of the field.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Gives all edges of one side of the field, which is next to straight, as many passes as any of them has:
/// how many corners were recorded along it makes no difference. Precondition: a polygon, and a
/// number for each of its edges.
/// O(n²) for n edges, as a rule O(n log n).
void take_whole_sides(const Ring& outer, double width_m, std::vector<int>& edge_passes);

}  // namespace tramline
