#pragma once
// A line over gaps as pieces of a plan.

#include <vector>

#include "tramline/planner/repair/gap_lines.h"

namespace tramline {

/// The line in the field's frame, in order along it: strip 0 of the grid. Its pieces belong to the subfield
/// and are the track of that number. O(pieces).
std::vector<TrackPiece> pieces_of(const GapLine& line, const StripGrid& grid, std::size_t subfield,
                                  int track);

}  // namespace tramline
