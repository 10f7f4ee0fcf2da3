#pragma once
// The work on one line over gaps.

#include <vector>

#include "tramline/planner/repair/repair_plan.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// One uninterrupted drive along a strip. Between its pieces the machine drives over land with the work off.
struct GapLine {
  std::vector<LaidPiece> pieces;  ///< along the strip; all except the first come after a crossing
  double length_m = 0;            ///< of the pieces
  double covered_m2 = 0;          ///< area of gaps that it covers
  int stops = 0;
};

/// Which pieces a line consists of.
enum class WantedPieces {
  kWorthDriving,  ///< those that save more than they cost
  kAll,
};

/// The lines on a strip, at most one for each stretch of open land that is at least as long as the swath is
/// wide. Their pieces lie where the end rule finds gaps (Track::subfield), breaks shorter than kLeastBreak_m
/// are worked through, and every piece is one of the `wanted`. Lines shorter than the machine's least length
/// are left out. `open`: where a whole swath may lie. O(breaks of the profile).
std::vector<GapLine> lines_on(const Track& strip, const Intervals& open, const RepairTerms& terms,
                              WantedPieces wanted);

/// The cost of a line without the turn to it: its stops and its overlap. A piece shorter than w counts as
/// long as w, and a line shorter than 2 w (the least length worth driving of Versleijen §2.2.1) as long as
/// that, because getting there and switching on and off cost something too; otherwise a long gap narrower
/// than w would be worked across in many short pieces.
double price_of(const GapLine& line, const RepairTerms& terms);

/// The saving of a line that covers `covered_m2` of missed land, less its cost without the turn to it.
double worth_of(const GapLine& line, double covered_m2, const RepairTerms& terms);

}  // namespace tramline
