#pragma once
// Polygons made from directed boundary edges.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// An edge with the land it bounds on its left.
struct DirectedEdge {
  Point from;
  Point to;
};

/// The polygons bounded by a set of edges: every edge is walked once, at every node the walk turns as
/// far left as it can, and rings that pass a node twice are split there, so that a hole that touches
/// its outer ring stays a hole. Ends of edges with equal coordinates are one node. Edges may meet at nodes
/// only, and at every node as many edges begin as end. Rings come in the order of their least edge (by
/// coordinates): the result does not depend on the order of the edges. O(n log n), and O(holes · n) for
/// placing the holes.
Region faces_of(std::vector<DirectedEdge> edges);

/// All edges of a polygon's rings, in order. Precondition: oriented.
std::vector<DirectedEdge> edges_of(const Polygon& polygon);

/// Union of polygons that share identical edges and do not overlap: edges walked both ways cancel.
/// Exact: no coordinate changes.
Region dissolved(const Region& cells);

}  // namespace tramline
