#pragma once
// The area that the swaths of a family of curved tracks work, in few polygons.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/track.h"

namespace tramline {

/// The swaths of curved pieces that run parallel to the reference, joined where they lie side by side. In
/// coordinates along and across one segment of the reference they are strips of a grid, like straight ones:
/// edges shared by neighbours are dropped before any arc becomes chords, and a field of arcs has as few
/// vertices as one of lines. Returns three regions whose parts do not overlap: that area, and the swaths of
/// every other track, and of the rest, where they round corners that the reference does not have. The regions
/// may overlap by the `sagitta_m` of chords. Frame: the field's. Tracks are numbered as in parallel_family():
/// piece.track's swath lies between track·w and (track + 1)·w to the right of the reference; the pieces may
/// be driven either way. Precondition: arcs' radii are at least half the width. O(n log n) for n segments of
/// all pieces, and O(corners · segments of the reference).
std::vector<Region> worked_bands(const Path& reference, const std::vector<TrackPiece>& pieces, double width_m,
                                 double sagitta_m);

}  // namespace tramline
