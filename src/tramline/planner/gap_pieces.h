#pragma once
// The track pieces of lines over gaps.

#include <vector>

#include "tramline/planner/gap_lines.h"

namespace tramline {

/// The pieces of the lines in the field's frame, line by line. They belong to the subfield; each line is a
/// track of its own, numbered from 0.
void append_pieces(const GapLines& lines, int subfield, std::vector<TrackPiece>& out);

}  // namespace tramline
