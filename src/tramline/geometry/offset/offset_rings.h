#pragma once
// The land that keeps a distance from boundaries: its exact boundary, of lines and arcs.

#include <limits>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// A ring with the free land on its left (a field's outer ring counter-clockwise, an obstacle's clockwise),
/// and the distance to keep from it.
struct OffsetBoundary {
  Ring ring;
  double distance_m = 0;      ///< > 0
  bool round_corners = true;  ///< false: no arcs about corners that stand out into the land: discs cover them
  /// Indices, ascending, of single vertices of which the same holds.
  std::vector<std::size_t> covered_corners{};
};

/// A disc that has to be kept free as well, or the part of it on one side of a line across it.
struct OffsetDisc {
  Point centre;
  double radius_m = 0;              ///< > 0
  std::size_t offset_boundary = 0;  ///< index of the boundary that requires it
  Point ahead{};                    ///< unit vector at right angles to the line; {0, 0}: the whole disc
  double line_m = -std::numeric_limits<double>::infinity();  ///< from the centre ahead to the line

  /// Whether a point lies on the side of the line that counts.
  bool counts_at(Point p) const { return dot(ahead, p - centre) >= line_m; }
};

/// A piece of the boundary, with the land that keeps its distance on its left. Arcs bend to the right: they
/// are about corners and discs.
struct OffsetPiece {
  PathSegment segment;
  Point centre{};        ///< of an arc
  Point from_heading{};  ///< unit vectors in driving direction; more exact than those from the segment's ends
  Point to_heading{};
  std::size_t offset_boundary = 0;  ///< index of the boundary that it keeps the distance from
};

/// Consecutive pieces, each beginning where the one before ended (up to 1e-8 m), closed. They turn to the
/// left where they meet, or not at all.
using OffsetRing = std::vector<OffsetPiece>;

/// The boundary of the free land whose points are at least an offset boundary's distance from each offset
/// boundary and outside all discs: counter-clockwise rings round it, clockwise ones round what has to be kept
/// off inside it. Parts that touch in a point are separate rings. Points that are too near to an offset
/// boundary by up to 1e-9 m may count as free. Preconditions: rings are simple and do not cross one another;
/// they may touch. Where a line cuts a disc, all of it inside the disc is too near to an offset boundary.
/// Throws Error(kFailure) where rounding leaves no boundary (no such case is known). O(n² + k·m) for n edges,
/// with k crossings of the lines at the distance and m edges near one.
std::vector<OffsetRing> offset_rings(const std::vector<OffsetBoundary>& offset_boundaries,
                                     const std::vector<OffsetDisc>& discs = {});

/// The same as polygons: arcs become chords that deviate by at most `sagitta_m`.
Region offset_region(const std::vector<OffsetRing>& rings, double sagitta_m);

}  // namespace tramline
