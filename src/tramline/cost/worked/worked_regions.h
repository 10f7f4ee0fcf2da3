#pragma once
// The overlap of a plan and what it leaves uncovered, as polygons for maps and pictures.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

struct WorkedRegions {
  Region overlap;    ///< worked outside the body, or by more than one swath
  Region uncovered;  ///< body that no swath covers
};

/// Computed by polygon booleans on the precision grid. Overlap of swaths is found pair by pair among those
/// whose boxes meet. `swaths` may be whole ones or parts that only touch: rectangles as such, bands along
/// arcs by their chords. `grounds`, where known, are regions that together cover what the swaths do; they may
/// overlap one another, the parts of one may not.
WorkedRegions worked_regions(const Region& body, const Region& swaths);
WorkedRegions worked_regions(const Region& body, const Region& swaths, const std::vector<Region>& grounds);

/// The common area of every two of the swaths; where three overlap, so do the parts. Every swath has to be
/// valid. O(n log n + k) for k pairs whose boxes meet along x.
Region common_to_two(const Region& swaths);

}  // namespace tramline
