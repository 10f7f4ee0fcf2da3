#pragma once
// What tracks made one from another amount to, by polygon booleans: their rows may overlap.

#include <vector>

#include "tramline/model/tally.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The swaths of the pieces in parts of the area width · length (kinked_line.h).
Region kinked_swaths(const std::vector<LaidPiece>& pieces, double width_m);

struct ZhouTally {
  Tally tally;
  Region worked;  ///< the union of all swaths
};

/// Of the body the swaths cover what their union does, each bit once: overlap = Σ w·L − area(∪ ∩ body) counts
/// what is worked twice, within one swath, too, and what is worked outside the body (more than S2.14, which
/// takes rows to be disjoint); uncovered = area(body) − area(∪ ∩ body). With both Σ w·L = body − uncovered +
/// overlap whatever the tracks are (S2.15). No part of a swath is larger than w times its length, so no
/// overlap is negative but for the grid that booleans are computed on.
/// Precondition: paths of straight segments.
ZhouTally zhou_tally(const LaidTracks& tracks, double width_m, const Region& body);

}  // namespace tramline
