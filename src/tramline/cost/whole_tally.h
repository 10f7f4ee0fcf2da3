#pragma once
// The tally of tracks and headland passes together.

#include <vector>

#include "tramline/model/headland.h"
#include "tramline/model/tally.h"
#include "tramline/model/track.h"

namespace tramline {

/// The tally of the tracks with its areas replaced by those of all swaths and headland passes against the
/// land (body and headland ground): overlap is the area they work outside the land or again, uncovered the
/// land that none of them works. Σ width · length of both = area of the land − uncovered + overlap. A swath
/// that runs on into the headland works land there which the passes leave, and passes work land in corners of
/// the body: so the areas are not sums of those of tracks and headland. Counts and track length stay those of
/// the tracks. Closed form, exact up to rounding (newly_covered_area()). Without headland ground the tally
/// itself. Frame: the field's local metres. `pieces` are those that `tracks` counts, in any order. O(n log n
/// + n·a) for n edges of pieces, passes and land, a of them at one height.
Tally whole_tally(const Tally& tracks, const std::vector<TrackPiece>& pieces, const Region& body,
                  const Headland& headland, double width_m);

}  // namespace tramline
