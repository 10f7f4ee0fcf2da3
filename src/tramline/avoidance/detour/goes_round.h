#pragma once
// The test of what a detour goes round among all that lies along it.

#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// Whether any of the ring lies between the detour's ends, on the side that the detour keeps away from. Both
/// in the plane of the grid; the ring does not meet the detour. O(n·m) for n edges and m segments.
bool goes_round(const TrackDetour& detour, const Ring& ring);

}  // namespace tramline
