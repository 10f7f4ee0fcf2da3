#pragma once
// The area of some land that swaths cover together, whatever their lines are.

#include <cstdint>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// How the land along a path is bounded.
enum class SwathEdges : std::uint8_t {
  kSmooth,  ///< by parallels of the path (append_band())
  kMitred,  ///< cell by cell, cut at kinks (kinked_cells())
};

struct CoveringSwath {
  Path path;
  SwathEdges edges = SwathEdges::kSmooth;
};

/// The area of the land that the swaths cover, each square metre once, m². The swaths may overlap, cross
/// themselves and one another, and lie outside the land. Closed form, exact up to rounding
/// (newly_covered_area()). `main`: the direction of most swaths; the area does not depend on it, but the time
/// does. Precondition: smooth paths have continuous tangents and radii of at least half the width, mitred
/// ones straight segments only; the polygons of all regions together do not overlap. O(n log n) for n edges
/// of which few cross any one height.
double covered_m2(const std::vector<CoveringSwath>& swaths, const std::vector<const Region*>& land,
                  double width_m, Direction main);

}  // namespace tramline
