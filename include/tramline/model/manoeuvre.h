#pragma once
// Manoeuvres: how a machine gets from the end of one track to the start of the next.

#include <string>
#include <string_view>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline {

/// kU: two equal turns to one side, quarter circles between parallel tracks, and a line between them. kOmega:
/// a turn out, one of more than half a circle, a turn back. kUnequalArcs: turns of different angle, or a line
/// on and then a U or omega, as at oblique borders (P). kFishtail: turn, reverse, turn. kDubins, kReedsShepp:
/// any other shortest path forward, or with reversing. kBackOut: back along the track.
enum class ManoeuvreKind { kU, kOmega, kUnequalArcs, kFishtail, kDubins, kReedsShepp, kBackOut };

const char* name(ManoeuvreKind kind);  ///< u, omega, unequal_arcs, fishtail, dubins, reeds_shepp, back_out

/// The way of the rear axle's middle, from the pose in which the work ends to the pose in which it begins.
struct Manoeuvre {
  ManoeuvreKind kind = ManoeuvreKind::kDubins;
  std::string word;  ///< a letter for each turn or line: L, R or S, in lower case where driven in reverse;
                     ///< a turn that begins and ends with clothoids is one letter and up to three stretches
  SteeredPath path;
};

/// Changes of gear, with those before and after it: the machine comes forward from the track and goes on
/// forward.
int gear_changes(const Manoeuvre& manoeuvre);

/// The time that the manoeuvre takes, s: lengths by the speeds of turning and reversing, and the changes of
/// gear.
double seconds(const Manoeuvre& manoeuvre, const Machine& machine);

}  // namespace tramline
