#pragma once
// Where a plan overlaps and what it leaves uncovered, as polygons for maps and pictures.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

struct WorkedRegions {
  Region overlap;    ///< worked outside the body, or by more than one swath
  Region uncovered;  ///< body that no swath covers
};

/// By polygon booleans on the precision grid. Overlapping swaths are told apart pair by pair among
/// those whose boxes meet. `swaths` may be whole ones or parts that only touch: rectangles as such, bands
/// along arcs by their chords. `grounds`, where they are known, are regions that cover together what the
/// swaths do; they may overlap, the parts of one may not.
WorkedRegions worked_regions(const Region& body, const Region& swaths);
WorkedRegions worked_regions(const Region& body, const Region& swaths, const std::vector<Region>& grounds);

/// What every two of the swaths have in common; where three do, the parts overlap. Every swath has to be
/// valid. O(n log n + k) for k pairs whose boxes meet along x.
Region common_to_two(const Region& swaths);

}  // namespace tramline
