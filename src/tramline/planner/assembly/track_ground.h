#pragma once
// What the tracks of a plan work, and what more than one of them does.

#include "tramline/planner/assembly/worked_layers.h"
#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// The ground of all swaths in few regions: the rows of straight tracks, the bands along curves, all detours.
/// Precondition: `plan` has its subfields, and the candidate's pieces.
TrackGround track_ground(const Plan& plan, const Candidate& candidate);

}  // namespace tramline
