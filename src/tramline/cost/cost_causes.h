#pragma once
// The causes of a plan's cost: the areas and counts of the tally, divided by what causes them.

#include <vector>

#include "tramline/model/explanation.h"
#include "tramline/model/objective.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// A boundary that needs more than this many widths along the strip to pass through it runs along it: it
/// makes less than 14 degrees with the tracks.
inline constexpr double kLongestRowEnd = 4;

/// A plan's tracks with the land they were laid on. Refers to its parts.
struct LaidPlan {
  const std::vector<Subfield>& subfields;
  const std::vector<TrackFamily>& families;  ///< by subfield, all of each
  const std::vector<LaidTracks>& tracks;     ///< by subfield, on these strips
  const Region& body;
  const Region& given_up;  ///< of the body; in no subfield
  const Region& passable;
  const Tally& tally;  ///< of these tracks
};

/// Closed form throughout: rows are cut at the ends of their causes, and the rest of each stretch is measured
/// between lines and arcs. O(K·n) for n edges of the body and K stretches, about three a strip.
CostCauses causes_of(const LaidPlan& plan, const Objective& objective);

}  // namespace tramline
