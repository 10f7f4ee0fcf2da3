#pragma once
// By how much each swath of a plan with curved tracks overlaps (S2.14).

#include "tramline/model/plan.h"

namespace tramline {

/// Settles by how much each swath overlaps. Precondition: pieces say what they would overlap without detours
/// (driven_tracks()), unless they are made by the paper's construction. As gain_by_detours_m2() and
/// overlap_by_kinked_piece().
void add_overlaps(Plan& plan);

}  // namespace tramline
