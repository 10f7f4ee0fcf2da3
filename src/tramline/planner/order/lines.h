#pragma once
// What is driven in one go, and tours over it.

#include <cstddef>
#include <vector>

#include "tramline/model/track.h"

namespace tramline::order {

/// The same way past an obstacle, seen by who comes from the other end.
inline Passing other_side(Passing way) {
  if (way == Passing::kCut) return way;
  return way == Passing::kLeft ? Passing::kRight : Passing::kLeft;
}

/// The pieces of one track that crossings join, or a piece by itself, in the sense of the track: every piece
/// but the first comes after a crossing. At least one.
using WorkedLine = std::vector<TrackPiece>;

/// The same ground driven the other way.
WorkedLine backwards(WorkedLine line);

/// The lines of pieces that come track by track, those of a track along it.
std::vector<WorkedLine> lines_of(const std::vector<TrackPiece>& pieces);

/// An end of a line, by number: 2·i is the start of line i, 2·i + 1 its end.
using End = std::size_t;
inline End other_end(End end) { return end ^ 1U; }
inline std::size_t line_of(End end) { return end / 2; }
inline bool is_start(End end) { return end % 2 == 0; }

/// Every line once, in driving order, by the end at which the machine comes to it; it leaves by the other.
using Tour = std::vector<End>;

/// The same tour driven the other way.
Tour backwards(const Tour& tour);

}  // namespace tramline::order
