#pragma once
// Areas of regions inside convex polygons, without building the intersection.

#include <vector>

#include "tramline/geometry/region.h"

namespace tramline {

/// Oriented rings taken as a winding function: area = Σ signed areas. Clipping by half planes keeps
/// that sum true although the clipped rings may run along the clip line twice (Sutherland–Hodgman).
using RingSet = std::vector<Ring>;

/// The rings of `rings` within the convex, counter-clockwise ring. O(n·k).
RingSet clipped(const RingSet& rings, const Ring& convex);
/// The intersection of two convex counter-clockwise rings; empty where they do not meet.
Ring convex_intersection(const Ring& a, const Ring& b);

double signed_area(const RingSet& rings);

/// Area of rings ∩ (A₁ ∪ A₂ ∪ …) for convex counter-clockwise rings, by
/// area(∪) = Σ_k [area(A_k) − area(∪_{j>k} A_j ∩ A_k)]. Quick where few of them overlap.
double area_in_union(const RingSet& rings, const std::vector<Ring>& convex);

}  // namespace tramline
