#pragma once
// The lines on which a machine works missed ground, one grid of parallel lines at a time.

#include <vector>

#include "tramline/model/machine.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/strip_pieces.h"

namespace tramline {

/// What repairs are laid for.
struct RepairTerms {
  Machine machine;
  Objective objective;
  EndRule end_rule = EndRule::kCover;
};

/// Missed ground that is worked together, and what lies about it. Frame: the field's local metres, oriented.
struct GapGround {
  Region gaps;
  Region free;  ///< where swaths may lie: the field less its obstacles, all of it within reach of the gaps
  Region obstacles;  ///< those within reach: a piece that ends at one of them is a stop
  double gaps_m2 = 0;
};

/// The part of `free` and of `obstacles` that lines over these gaps can meet. One polygon boolean for each.
GapGround gap_ground(Region gaps, const Region& free, const Region& obstacles, double width_m);

/// One uninterrupted drive along a strip. Between its pieces the work is off, on ground that may be driven.
struct GapLine {
  std::vector<StripPiece> pieces;  ///< along the strip; those after the first are after a crossing
  double length_m = 0;             ///< of the pieces
  double covered_m2 = 0;           ///< of the gaps
  int stops = 0;
};

struct GapLines {
  StripGrid grid;
  std::vector<GapLine> lines;  ///< by strip, then along
  double covered_m2 = 0;
  double price = 0;  ///< see price_of()
};

/// Narrower ground than this, across the strip, is not what a piece is driven for, m: the tails of a gap
/// between two passes that all but touch. Ground left so is looked at again.
inline constexpr double kTail_m = 0.05;

/// All lines of a grid: pieces where the end rule finds gaps wider than `least_width_m` in the strip, within
/// stretches of free ground at least as long as the swath is wide. Breaks shorter than kLeastBreak_m are
/// worked through; lines shorter than the machine's least length are left out. O(n + K log K).
GapLines lines_on(const GapGround& ground, const StripGrid& grid, const RepairTerms& terms,
                  double least_width_m);

/// What a line is taken to cost when lines are chosen: a turn, its stops, and its overlap. A piece shorter
/// than w is priced as if it were so long, and a line shorter than 2 w (the least length worth driving of
/// S1.14) as one of that length: to get there, to switch on and off again costs something too, or else a long
/// gap narrower than w would be worked across in many short pieces.
double price_of(const GapLine& line, const RepairTerms& terms);

/// The pieces of the lines, as tracks of their grid.
SubfieldTracks tracks_of(const GapLines& lines);

}  // namespace tramline
