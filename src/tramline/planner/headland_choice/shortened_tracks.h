#pragma once
// What headlands leave of the tracks of a layout.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/headland_choice/passes_by_boundary.h"

namespace tramline {

/// The pieces of a layout without headlands, in its order, cut back to where they are as far from the edges
/// of the field and of its obstacles as the passes there are wide; rests shorter than the machine works are
/// left out, and straight tracks that pass before a headland are parted by it. Curved pieces and those with
/// detours are cut back from their ends only, the former to within a quarter of a width. It foretells where
/// tracks will end, without a single operation on polygons. O(p · n) for p pieces.
std::vector<TrackPiece> shortened_tracks(const Plan& layout, const PassesByBoundary& passes);

}  // namespace tramline
