#pragma once
// The exact area of the body that detours cover: swaths along arcs are cut by lines and arcs, not by chords.

#include <vector>

#include "tramline/cost/worked/worked_ground.h"

namespace tramline {

/// Area of the body that detours cover and no part of a track outside its detours does, m². `tracks` by
/// family. O(d·m) for d detours and m edges of the body.
double covered_by_detours_m2(const Region& body, const std::vector<TrackFamily>& families,
                             const std::vector<LaidTracks>& tracks);

}  // namespace tramline
