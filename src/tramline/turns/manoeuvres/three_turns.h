#pragma once
// Turn, turn, turn with changes of gear between, for turns with clothoids too.

#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// The words LRL and RLR with at least one change of gear, in all gears and with the middle turn to either
/// side of the way, as far as they exist with turns of at most half a circle; the shortest first. For arcs
/// they include the words C|C|C, C|CC and CC|C of Reeds and Shepp (1990). With clothoids the wheels are
/// straight ahead wherever two turns meet, at changes of gear too, so the path is exact for a machine that
/// does not steer while it stands. One that does could save a clothoid on both sides of each change (Banzhaf
/// et al. 2017): that is not done. Kind kReedsShepp. Metres; ends in `to` within 1e-9.
std::vector<Manoeuvre> three_turns(const Pose& from, const Pose& to, const TurnCurves& curves);

}  // namespace tramline
