#pragma once
// Lines driven without a turn, and tours over them.

#include <cstddef>
#include <vector>

#include "tramline/model/track.h"

namespace tramline::order {

/// The same way past an obstacle, seen when driving in the opposite direction.
inline Passing other_side(Passing way) {
  if (way == Passing::kCut) return way;
  return way == Passing::kLeft ? Passing::kRight : Passing::kLeft;
}

/// The pieces of one track that crossings join, or a single piece, in the direction of the track: every piece
/// except the first comes after a crossing. At least one.
using WorkedLine = std::vector<TrackPiece>;

/// The same line driven in the opposite direction.
WorkedLine backwards(WorkedLine line);

/// The lines formed by pieces that are ordered track by track and along each track.
std::vector<WorkedLine> lines_of(const std::vector<TrackPiece>& pieces);

/// An end of a line, by number: 2·i is the start of line i, 2·i + 1 its end.
using End = std::size_t;
inline End other_end(End end) { return end ^ 1U; }
inline std::size_t line_of(End end) { return end / 2; }
inline bool is_start(End end) { return end % 2 == 0; }

/// Every line once, in driving order, given by the end at which the machine enters it; it leaves by the
/// other.
using Tour = std::vector<End>;

/// The same tour driven in the opposite direction.
Tour backwards(const Tour& tour);

}  // namespace tramline::order
