#pragma once
// Corners too sharp to drive along at a distance: where the pass has to swing wide, and how wide.

#include <vector>

#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// Discs of radius `radius_m` that keep a pass off the arcs of `rings` that are tighter than that. Outside
/// the offset_boundaries' distances and these discs the land has no such arcs: each is covered by a disc,
/// which touches it in its middle from the side of the land if it has the disc for itself. Corners close
/// together share a disc where that takes away less of the level than a disc for each. O(n²) for n tight arcs
/// that follow one another closely.
std::vector<OffsetDisc> wide_corners(const std::vector<OffsetRing>& rings, double radius_m);

}  // namespace tramline
