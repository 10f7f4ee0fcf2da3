#pragma once
// The land that keeps a distance from offset_boundaries: its boundary, exactly, of lines and arcs.

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// A ring with the free land on its left (a field's outer ring counter-clockwise, an obstacle's clockwise),
/// and how far from it one has to stay.
struct OffsetBoundary {
  Ring ring;
  double distance_m = 0;      ///< > 0
  bool round_corners = true;  ///< false: corners that stand out into the land are somebody else's business
                              ///< (a disc's): no arcs about them
};

/// A disc that has to be kept free, too.
struct OffsetDisc {
  Point centre;
  double radius_m = 0;              ///< > 0
  std::size_t offset_boundary = 0;  ///< on whose behalf
};

/// A piece of the boundary, the land that keeps its distance on its left. Arcs bend to the right: they are
/// about corners and discs.
struct OffsetPiece {
  PathSegment segment;
  Point centre{};        ///< of an arc
  Point from_heading{};  ///< unit vectors in driving direction; better than what the segment's ends tell
  Point to_heading{};
  std::size_t offset_boundary = 0;  ///< an index: whom it keeps the distance from
};

/// Pieces one after the other, each beginning where the last one ended (up to 1e-8 m), without gap at the
/// end. They turn to the left where they meet, or not at all.
using OffsetRing = std::vector<OffsetPiece>;

/// The boundary of the free land whose points are at least a offset_boundary's distance from each
/// offset_boundary and outside all discs: counter-clockwise rings round it, clockwise ones where something in
/// it is kept off. Parts that touch in a point are rings of their own. Points nearer to a offset_boundary by
/// 1e-9 m may be taken for free. Precondition: rings are simple and do not cross one another; they may touch.
/// Throws Error(kFailure) where rounding leaves no boundary (none known).
/// O(n² + k·m) for n edges, with k crossings of the lines at the distance and m edges near one.
std::vector<OffsetRing> offset_rings(const std::vector<OffsetBoundary>& offset_boundaries,
                                     const std::vector<OffsetDisc>& discs = {});

/// The same as polygons: arcs become chords that are off by at most `sagitta_m`.
Region offset_region(const std::vector<OffsetRing>& rings, double sagitta_m);

}  // namespace tramline
