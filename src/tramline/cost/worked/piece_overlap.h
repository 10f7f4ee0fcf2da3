#pragma once
// The overlap of each swath of a plan (Zhou §2.3.5).

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The part of each piece's swath that lies outside the body or is worked by a piece before it, m², in the
/// order of the pieces, which is that of driving. Area that two swaths share counts for the later one, so
/// that the sum over all pieces is the overlap of the plan: Σ w·L − area(body ∩ ∪ swaths). Zhou counts only
/// what lies outside the body, since its swaths never meet. Closed form, exact up to rounding
/// (newly_covered_area()). Precondition: the pieces belong to the subfields; curved ones have no kinks and
/// state their own overlap without detours (TrackPiece::overlap_m2), which stays where they have none and
/// meet nothing worked before. About O(n·(v + n)) for n pieces and v corners of the body.
std::vector<double> overlap_by_piece(const Region& body, const std::vector<Subfield>& subfields,
                                     const std::vector<TrackPiece>& pieces, double width_m);

}  // namespace tramline
