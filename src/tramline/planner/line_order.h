#pragma once
// In which order lines over gaps are driven.

#include <vector>

#include "tramline/planner/gap_lines.h"

namespace tramline {

/// The pieces of one line, in driving order.
using WorkedLine = std::vector<TrackPiece>;

/// The lines in the field's frame. Their pieces belong to the subfield; each line is a track of its own,
/// numbered from 0.
void append_lines(const GapLines& lines, int subfield, std::vector<WorkedLine>& out);

/// The first line, then always the line with an end nearest to where the machine is, from that end; among
/// equals the first. O(n²).
std::vector<TrackPiece> in_driving_order(std::vector<WorkedLine> lines);

}  // namespace tramline
