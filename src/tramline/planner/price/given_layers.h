#pragma once
// The land that given lines work, as polygons.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline {

/// The swaths along paths, in parts: a cell for each segment of one with kinks, else a band. Arcs as chords
/// (`sagitta_m`). The parts may overlap.
Region swath_grounds(const std::vector<Path>& paths, double width_m, double sagitta_m);

/// The part of the land about the swaths of some lines: the largest polygon of it within their convex hull,
/// or that hull where they lie outside. Precondition: paths is not empty.
Polygon land_about(const std::vector<const Path*>& paths, double width_m, const Region& land);

/// Sets the layers Plan::overlap and Plan::uncovered. They show the areas of the tally, without slivers
/// between the chords of swaths that share an arc. Precondition: the plan has its body and its headland.
void add_layers_of_lines(const std::vector<Path>& tracks, const std::vector<Path>& passes, Plan& plan);

}  // namespace tramline
