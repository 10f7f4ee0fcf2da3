#pragma once
// What a plan's cost is made of: the same areas and counts as the tally's, parted by what causes them.

#include <vector>

#include "tramline/model/explanation.h"
#include "tramline/model/objective.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// A boundary that takes longer than this many widths along to pass through a strip runs along it: it makes
/// less than 14 degrees with the tracks.
inline constexpr double kLongestRowEnd = 4;

/// A plan that has been laid out, and the ground it was laid on. Refers to its parts.
struct LaidPlan {
  const std::vector<Subfield>& subfields;
  const std::vector<TrackFamily>& families;  ///< by subfield, all of each
  const std::vector<LaidTracks>& tracks;     ///< by subfield, on these strips
  const Region& body;
  const Region& given_up;  ///< of the body; in no subfield
  const Region& passable;
  const Tally& tally;  ///< of these tracks
};

/// Closed form throughout: rows are cut at the ends of their causes, and what is left of each stretch is
/// measured between lines and arcs. O(K·n) for n edges of the body and K stretches, about three a strip.
CostCauses causes_of(const LaidPlan& plan, const Objective& objective);

}  // namespace tramline
