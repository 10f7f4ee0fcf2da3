#pragma once
// What a machine works of missed ground on one line.

#include <vector>

#include "tramline/planner/repair/repair_terms.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// One uninterrupted drive along a strip. Between its pieces the work is off, on ground that may be driven.
struct GapLine {
  std::vector<LaidPiece> pieces;  ///< along the strip; those after the first are after a crossing
  double length_m = 0;            ///< of the pieces
  double covered_m2 = 0;          ///< of the gaps
  int stops = 0;
};

/// Which pieces a line has.
enum class WantedPieces {
  kWorthDriving,  ///< those that win back more than they cost
  kAll,
};

/// The lines on a strip, one at most for each stretch of open ground at least as long as the swath is wide.
/// Their pieces lie where the end rule finds gaps (Track::subfield), breaks shorter than kLeastBreak_m are
/// worked through, and every piece is wanted. Lines shorter than the machine's least length
/// are left out. `open`: where a whole swath may lie. O(breaks of the profile).
std::vector<GapLine> lines_on(const Track& strip, const Intervals& open, const RepairTerms& terms,
                              WantedPieces wanted);

/// What a line costs, but for the turn to it: its stops and its overlap, where a piece shorter than w counts
/// as one of w, and a line shorter than 2 w (the least length worth driving of S1.14) as one of that length:
/// to get there, to switch on and off again costs something too, or else a long gap narrower than w would be
/// worked across in many short pieces.
double price_of(const GapLine& line, const RepairTerms& terms);

/// What is won by a line that works so much missed ground, less what it costs, but for the turn to it.
double worth_of(const GapLine& line, double covered_m2, const RepairTerms& terms);

}  // namespace tramline
