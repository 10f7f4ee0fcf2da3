#pragma once
// The land that the tracks of a plan work, and the land that more than one of them works.

#include "tramline/planner/assembly/worked_layers.h"
#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// The land of all swaths in few regions: the rows of straight tracks, the bands along curves, and all
/// detours. Precondition: `plan` has its subfields and the candidate's pieces.
TrackGround track_ground(const Plan& plan, const Candidate& candidate);

}  // namespace tramline
