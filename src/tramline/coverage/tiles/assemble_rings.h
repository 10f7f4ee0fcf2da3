#pragma once
// Assembles the outlines of tiles to polygons.

#include <vector>

#include "tramline/coverage/tiles/tile_outline.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// Polygons and holes that are thinner than this on average (twice the area over the perimeter) are dropped,
/// units: 1 µm for tiles of 8 m.
inline constexpr double kThinnest = 128;

/// The polygons whose boundary the outlines are, with `border` added to it. Where tiles meet, boundaries
/// walked both ways cancel. Rings are simple: where the region touches itself at a point it is separated
/// there. Polygons are in the order of the least points of their boundaries. O(n log n).
Region assembled(const std::vector<TileOutline>& outlines, std::vector<BorderEdge> border,
                 const TileFrame& frame);

}  // namespace tramline::coverage
