#pragma once
// All ways in which a machine may get from the end of one track to the start of the next.

#include <vector>

#include "tramline/model/machine.h"
#include "tramline/model/manoeuvre.h"

namespace tramline {

/// The manoeuvres that the machine can drive between two poses, each once and under its own name, the
/// quickest first: seconds() in whole tenths of a microsecond, then changes of gear, then the order of
/// ManoeuvreKind, then the word. These are the words of Dubins with the U, the omega and the turns of unequal
/// arcs among them, and the line on that makes ends level. With machine.turning.reverse, unless the machine
/// tows on a drawbar, also fishtails, Dubins' words in reverse, and the words of Reeds and Shepp (1990); with
/// a steering time those of three turns only (three_turns()). Not the way back along the track: see
/// back_out(), whose length depends on the room.
///
/// Nothing is known here of the room that there is. Metres; every manoeuvre ends in `to` within 1e-9. Never
/// empty where steering_time_s is 0. Precondition: machine.radius_m > 0 and all speeds > 0.
std::vector<Manoeuvre> manoeuvres_between(const Pose& from, const Pose& to, const Machine& machine);

}  // namespace tramline
