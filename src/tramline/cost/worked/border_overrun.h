#pragma once
// What swaths that run past a border between subfields cover beyond it.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// `tracks` by subfield. Land of all subfields that swaths of other subfields, detours left aside, cover and
/// their own do not, m². Straight ones are cut by convex clipping, curved ones by lines and arcs
/// (newly_covered_area()).
double covered_by_neighbours_m2(const std::vector<Subfield>& subfields,
                                const std::vector<LaidTracks>& tracks);

}  // namespace tramline
