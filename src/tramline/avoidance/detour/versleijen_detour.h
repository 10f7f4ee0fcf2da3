#pragma once
// S1's own way round obstacles: category a of its table 3.

#include "tramline/avoidance/detour/way_round.h"

namespace tramline {

/// S1.26-S1.39 for one gap. An obstacle whose extent across the track is below `threshold_m` is driven round
/// on the side with the smaller displacement (left among equals): a circle by the auxiliary circles of
/// S1.31-S1.35 with the pass radius max(R_o + w/2, r), any other shape along its buffer of w/2 (S1.36-S1.38).
/// Where the construction is too tight for the machine (S1.61), leaves the field or meets something else,
/// `why_not` gives the reason and the track has to be cut (S1.40).
WayRound versleijen_detour(const Obstruction& obstruction, double threshold_m, const Surroundings& around);

}  // namespace tramline
