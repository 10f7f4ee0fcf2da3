#pragma once
// The common areas of swaths, as polygons.

#include "tramline/model/plan.h"

namespace tramline {

/// The area that more than one piece works, or one piece twice by its detours; where three do, the parts
/// overlap. Straight swaths as in common_to_two(); along curves without slivers between the chords of swaths
/// that share an arc (is_sliver()): where they keep to their tracks, those of one subfield have no area in
/// common. Precondition: no piece has kinks. O(n log n + k) for n segments of all pieces and k pairs that
/// meet.
Region doubled_ground(const Plan& plan);

/// Whether a polygon is only a sliver that chords of neighbouring swaths leave open or share.
bool is_sliver(const Polygon& part);

/// Adds the swath along a path. Round arcs of half the width the inner edge of a band shrinks to a point, and
/// chords may fold there; no part added does.
void append_swath(const Path& path, double width_m, Region& out);

}  // namespace tramline
