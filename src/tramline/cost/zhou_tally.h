#pragma once
// The tally of tracks made one from another, by polygon booleans: their rows may overlap.

#include <vector>

#include "tramline/model/tally.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The swaths of the pieces, in parts of the area width · length each (kinked_line.h).
Region kinked_swaths(const std::vector<LaidPiece>& pieces, double width_m);

struct ZhouTally {
  Tally tally;
  Region worked;  ///< the union of all swaths
};

/// The swaths cover of the body what their union does, every part counted once: overlap = Σ w·L − area(∪ ∩
/// body) counts what is worked twice, also within one swath, and what is worked outside the body (more than
/// Zhou §2.3.5, which takes rows to be disjoint); uncovered = area(body) − area(∪ ∩ body). With both Σ w·L =
/// body − uncovered + overlap whatever the tracks are. No part of a swath is larger than w times its length,
/// so no overlap is negative except for the grid that booleans are computed on. Precondition: paths of
/// straight segments.
ZhouTally zhou_tally(const LaidTracks& tracks, double width_m, const Region& body);

}  // namespace tramline
