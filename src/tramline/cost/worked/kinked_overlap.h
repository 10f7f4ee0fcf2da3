#pragma once
// The overlap of each swath where tracks are made one from another, with kinks (Zhou §2.3.5).

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/track.h"

namespace tramline {

/// As overlap_by_piece(), for pieces of straight segments that meet in kinks: width · length less the body
/// that the cells of the swath (kinked_cells()) cover and no cell before them does, m². Area that a swath
/// works twice by itself counts, so the sum is Σ w·L − area(body ∩ ∪ swaths), the overlap of zhou_tally()
/// without the grid of its booleans. Closed form, exact up to rounding (newly_covered_area()). O(n·(m + k))
/// for n cells, m edges of the body and k cells before and near one.
std::vector<double> overlap_by_kinked_piece(const Region& body, const std::vector<TrackPiece>& pieces,
                                            double width_m);

}  // namespace tramline
