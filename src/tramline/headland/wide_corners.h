#pragma once
// Discs at corners too sharp to drive along at the pass's distance, round which the pass swings wide.

#include <vector>

#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// Discs of radius `radius_m` that keep a pass off the arcs of `rings` that are tighter than that. Outside
/// the offset boundaries' distances and these discs the land has no such arcs: each is covered by a disc,
/// which touches it in its middle from the land's side unless it shares the disc. Corners close together
/// share a disc where that takes less of the offset line than a disc for each. O(n²) for n tight arcs that
/// follow one another closely, O(n·m) for m pieces of all rings.
///
/// Only what a disc has ahead of its corners counts where that is enough: behind a corner of a thin obstacle
/// it would reach out over the other side. `all`: the rings with what passes are not driven along.
std::vector<OffsetDisc> wide_corners(const std::vector<OffsetRing>& rings, const std::vector<OffsetRing>& all,
                                     double radius_m);

}  // namespace tramline
