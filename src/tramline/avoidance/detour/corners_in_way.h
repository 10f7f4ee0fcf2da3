#pragma once
// What of hazards a detour has to go round.

#include <map>
#include <vector>

#include "tramline/avoidance/detour/detour_path.h"
#include "tramline/geometry/interval.h"

namespace tramline {

/// Parts of hazards the detour has to go round, by hazard: positions along the track.
using Parts = std::map<std::size_t, Interval>;

/// False where the part was known.
bool extend(Parts& parts, std::size_t hazard, Interval range);

/// Corners of the part of a ring with from ≤ x ≤ to and y ≥ bottom, as discs of this radius. The frame is the
/// detour's.
void append_corners(const Ring& ring, Interval range, double bottom, double radius,
                    std::vector<KeepOut>& out);

}  // namespace tramline
