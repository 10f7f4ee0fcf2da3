#pragma once
// What swaths that run past a border between subfields cover beyond it.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// `tracks` by subfield, or of all of them together. Land of all subfields that straight swaths of other
/// subfields cover and their own do not, m².
double covered_by_neighbours_m2(const std::vector<Subfield>& subfields,
                                const std::vector<LaidTracks>& tracks);

}  // namespace tramline
