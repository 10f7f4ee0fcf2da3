#pragma once
// Where a plan works land twice or in vain and where it leaves land, as polygons.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline {

/// What the tracks of a plan work.
struct TrackGround {
  std::vector<Region> grounds;  ///< together all that the swaths cover; the parts of one do not overlap
  Region doubled;               ///< what more than one of them works; parts may overlap
};

/// The layers Plan::overlap and Plan::uncovered of tracks and headland passes together: pictures of the
/// tally, without slivers between the chords of swaths that share an arc. Precondition: everything else but
/// tally, cost and warnings is there.
void add_layers(Plan& plan, TrackGround tracks);

}  // namespace tramline
