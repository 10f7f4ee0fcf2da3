#pragma once
// The land that swaths work, and the part of it that several of them work.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

struct SwathUnion {
  Region all;      ///< worked by any; its polygons do not overlap
  Region doubled;  ///< worked by two or more; its polygons do not overlap
};

/// Computed by polygon booleans on the precision grid, half by half: what each half works twice, and what
/// both work. Swaths that follow one another should lie near one another. Each has to be valid. Slivers that
/// chords of neighbouring swaths share (is_sliver()) do not count as worked twice. Takes log n overlays of
/// each vertex of the outlines, not of those of all pairs that meet.
SwathUnion swath_union(const Region& swaths);

/// The land that both regions work, without slivers (is_sliver()). Polygons of one do not overlap.
Region common_land(const Region& a, const Region& b);

/// The union of regions, the polygons of each of which do not overlap. Regions that do not meet are not
/// overlaid. O(r²) boxes besides the overlays.
Region united_regions(std::vector<Region> regions);

}  // namespace tramline
