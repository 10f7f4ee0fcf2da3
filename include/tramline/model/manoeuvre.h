#pragma once
// Manoeuvres: how a machine gets from the end of one track to the start of the next.

#include <string>
#include <string_view>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline {

/// kU: two quarter turns and a line between them. kOmega: an arc out, one of more than half a circle, an arc
/// back. kUnequalArcs: arcs of different angle, as at oblique borders (P). kFishtail: quarter turn, reverse,
/// quarter turn. kDubins, kReedsShepp: any other shortest path forward, or with reversing. kBackOut: back
/// along the track.
enum class ManoeuvreKind { kU, kOmega, kUnequalArcs, kFishtail, kDubins, kReedsShepp, kBackOut };

const char* name(ManoeuvreKind kind);  ///< u, omega, unequal_arcs, fishtail, dubins, reeds_shepp, back_out

/// The way of the rear axle's middle, from the pose in which the work ends to the pose in which it begins.
struct Manoeuvre {
  ManoeuvreKind kind = ManoeuvreKind::kDubins;
  std::string word;  ///< a letter for each stretch: L, R or S, in lower case where it is driven in reverse
  SteeredPath path;
};

/// The time that the manoeuvre takes, s: lengths by the speeds of turning and reversing, and the changes of
/// gear.
double seconds(const Manoeuvre& manoeuvre, const Machine& machine);

}  // namespace tramline
