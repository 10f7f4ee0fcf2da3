#pragma once
// Where a plan with curved tracks overlaps and what it leaves, as polygons for maps and pictures.

#include "tramline/planner/curved_family.h"

namespace tramline {

/// The layers of overlap and uncovered land of parallel tracks, headland passes among them (add_layers()).
void add_curved_layers(Plan& plan);

/// Those of tracks made as in the paper, from the union of the swaths that the candidate has.
void add_kinked_layers(Plan& plan, const CurvedCandidate& candidate);

}  // namespace tramline
