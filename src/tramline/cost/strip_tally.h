#pragma once
// Overlap, uncovered area, turns and stops of a whole plan in closed form.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// The tally of all subfields' tracks. Exact up to rounding, also where swaths of one subfield run
/// into another: the swaths of one subfield are disjoint where they keep to their tracks (parallel.h), so the
/// useful area is
///   Σ area(swath ∩ own subfield) + Σ_i area(S_i ∩ ∪ swaths of others, less the own swaths of S_i),
/// the second sum by covered_by_neighbours_m2(). No swath enters hard or passable land, so nothing outside
/// the subfields is useful. `subfields` and `tracks` correspond. `body_m2` is the area of the body,
/// `by_detours_m2` the area of it that only detours cover (covered_by_detours_m2).
Tally tally_of(const std::vector<Subfield>& subfields, const std::vector<LaidTracks>& tracks, double body_m2,
               double by_detours_m2 = 0);

}  // namespace tramline
