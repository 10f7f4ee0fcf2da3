#pragma once
// How a Dubins word is called among the turns at the end of a track.

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/dubins_solutions.h"

namespace tramline {

// Turns bring a machine back: their headings at start and end differ by more than a quarter circle. Sabelhaus
// et al. (2013) name the turns of headlands so. Equal arcs: within kEqualArcs_rad.

/// LSL or RSR: kU where both turns are equal and together less than a circle, or are one without a line;
/// kUnequalArcs where they are not equal, otherwise kDubins (a turn missing, a loop, a way on).
ManoeuvreKind kind_of_one_sided(const TurnLineTurn& word, const RelativePose& to);

/// LRL or RLR: kOmega where the first and the last turn are equal and each less than half a circle,
/// kUnequalArcs where they differ and are less (one may be missing), otherwise kDubins.
ManoeuvreKind kind_of_three_turns(const ThreeTurns& word, const RelativePose& to);

}  // namespace tramline
