#pragma once
// What detours change in what each swath of curved tracks works first (S2.14).

#include <vector>

#include "tramline/geometry/region.h"
#include "tramline/model/track.h"

namespace tramline {

/// By how much of the body, m², each piece's swath works more before all others than it would if every piece
/// worked only where it keeps to its track: what its detours work first, less what it works again because
/// detours of pieces before it have been there. In the order of the pieces, which is that of driving; the sum
/// is covered_by_detours_m2(). Closed form, exact up to rounding (new_area()). Precondition: pieces of one
/// family of parallel tracks, whose swaths have no ground in common where they keep to their tracks.
/// O(n + d·m) for n segments of pieces, d detours and m edges of the body.
std::vector<double> gain_by_detours_m2(const Region& body, const std::vector<TrackPiece>& pieces,
                                       double width_m);

}  // namespace tramline
