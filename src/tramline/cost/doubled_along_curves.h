#pragma once
// What swaths along curves have in common with others, as polygons.

#include "tramline/model/plan.h"

namespace tramline {

/// What pieces of curved tracks work that other pieces do, too, or they themselves with their detours; where
/// three do, the parts overlap. Without slivers between the chords of swaths that share an arc (is_sliver()).
/// Where they keep to their tracks, swaths of one subfield have no ground in common. O(n log n + k) for n
/// segments of all pieces and k pairs that meet.
Region doubled_along_curves(const Plan& plan);

/// Is a polygon no more than what chords of neighbouring swaths leave open or share?
bool is_sliver(const Polygon& part);

/// Adds the ground along a path. Round arcs of half the width the inner edge of a band shrinks to a point,
/// and chords may fold there: no part does.
void append_swath(const Path& path, double width_m, Region& out);

}  // namespace tramline
