#pragma once
// The area that swaths cover beyond a border between subfields.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// Land of all subfields that swaths of other subfields cover and their own do not, m²; detours are left out.
/// `tracks` by subfield. Straight ones are cut by convex clipping, curved ones by lines and arcs
/// (newly_covered_area()).
double covered_by_neighbours_m2(const std::vector<Subfield>& subfields,
                                const std::vector<LaidTracks>& tracks);

}  // namespace tramline
