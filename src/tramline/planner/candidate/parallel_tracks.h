#pragma once
// The tracks of a subfield parallel to its reference (Zhou §2.3.4).

#include "tramline/planner/candidate/candidate.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The land and the obstacles that tracks parallel to a curve have to respect on a subfield.
CurvedGround curved_ground(const SearchTask& task, const Polygon& shape);

/// The least radii of curved tracks of the machine.
TrackLimits track_limits(const Machine& machine);

/// The numbers of the parallels of a subfield's reference that may reach the subfield. Precondition: the
/// subfield has a reference, which extends beyond its box at both ends or goes all the way round.
StripRange parallels_over(const SearchTask& task, const Subfield& subfield);

EndCriterion end_criterion_of(const SearchTask& task);

/// All parallels of a subfield's reference, offset by (k + ½)·w to either side, that can be driven somewhere.
/// Precondition: as parallels_over().
TrackFamily parallel_tracks(const SearchTask& task, const CurvedGround& ground, const Subfield& subfield);

}  // namespace tramline
