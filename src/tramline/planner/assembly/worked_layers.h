#pragma once
// The overlap and the uncovered land of a plan as polygons.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The land that the tracks of a plan work.
struct TrackGround {
  /// Together they cover all that the swaths do; polygons of one region do not overlap.
  std::vector<Region> regions;
  Region doubled;                      ///< land that more than one region covers; its polygons may overlap
  std::vector<Region> also_doubled{};  ///< more such land; polygons of one region do not overlap
};

/// Sets the layers Plan::overlap and Plan::uncovered of tracks and headland passes together. They show the
/// areas of the tally, without slivers between the chords of swaths that share an arc. Precondition: `plan`
/// is complete except for tally, cost and warnings. The layers are the same for any number of threads.
/// Headland passes and pieces are read, and may be read elsewhere at the same time.
void add_layers(Plan& plan, TrackGround tracks, const SearchContext& context);

}  // namespace tramline
