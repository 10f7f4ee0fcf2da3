#pragma once
// Areas of regions inside convex polygons, without building the intersection.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Oriented rings taken as a winding function: area = Σ signed areas. Clipping by half planes keeps
/// that sum true although the clipped rings may run along the clip line twice (Sutherland–Hodgman).
using RingSet = std::vector<Ring>;

/// A convex polygon as the half planes left of its edges. Intersections keep the edges of the polygons they
/// come from: the vertices of a clipped polygon may nearly coincide, and the line through two such vertices
/// has no reliable direction.
struct ConvexSet {
  struct Edge {
    Point from;
    Point to;
  };
  std::vector<Edge> edges;
  Box box;  ///< contains the set
};

/// Precondition: convex, counter-clockwise, edges much longer than rounding.
ConvexSet convex_set(const Ring& ring);
ConvexSet common(const ConvexSet& a, const ConvexSet& b);

/// The rings of `rings` within the set. O(n·k) for k edges.
RingSet clipped(const RingSet& rings, const ConvexSet& set);
/// The intersection of two convex counter-clockwise rings; empty where they do not meet. Its vertices may
/// nearly coincide: fit for areas and pictures, not for clipping by it.
Ring convex_intersection(const Ring& a, const Ring& b);

double signed_area(const RingSet& rings);

/// Area of rings ∩ (A₁ ∪ A₂ ∪ …) by area(∪) = Σ_k [area(A_k) − area(∪_{j>k} A_j ∩ A_k)]. Fast where few of
/// the sets overlap.
double area_in_union(const RingSet& rings, const std::vector<ConvexSet>& sets);

}  // namespace tramline
