#pragma once
// Versleijen's own way round obstacles: category a of table 3.

#include "tramline/avoidance/detour/way_round.h"

namespace tramline {

/// Versleijen §2.2.4 for one gap. An obstacle whose extent across the track is below `threshold_m` is driven
/// round on the side with the smaller displacement (left among equals): a circle by the auxiliary circles of
/// Versleijen fig. 18 with the pass radius max(R_o + w/2, r), any other shape along its buffer of w/2 (fig.
/// 19). Where the construction is too tight for the machine (§4.2.2), leaves the field or meets something
/// else, `why_not` gives the reason and the track has to be cut (fig. 20).
WayRound versleijen_detour(const Obstruction& obstruction, double threshold_m, const Surroundings& around);

}  // namespace tramline
