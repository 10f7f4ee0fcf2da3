#pragma once
// The shortest ways forward from one pose to another.

#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// The words LSL, RSR, LSR, RSL, LRL and RLR of Dubins (1957) between two poses, as far as they exist, the
/// shortest first (of equal ones in this order): the formulas of Shkel and Lumelsky (2001) from the centres
/// of the turns. The shortest of them is the shortest way forward of least radius `radius_m`. Parts without
/// length are left out, so a word may have one letter, or none between equal poses; what then repeats another
/// word is left out. The kind is kU, kOmega or kUnequalArcs where turn_kind.h says so, otherwise kDubins.
/// Metres, frame of the poses. Ends in `to` within 1e-9 of the distance and radius. Precondition: radius_m >
/// 0.
std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, double radius_m);
/// The same with clothoids at both ends of every turn (Fraichard and Scheuer 2004); a word exists where there
/// is room for them, so between near poses there may be fewer and longer ways, and in rare cases none. As the
/// steering time goes to 0 the words become those above.
std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, const TurnCurve& curve);

/// The length of the shortest of them, m, without building any. 0 between equal poses. O(1), allocates
/// nothing. Precondition: radius_m > 0.
double dubins_length(const Pose& from, const Pose& to, double radius_m);
/// The shortest of dubins_words(), without building the others. Precondition: radius_m > 0.
Manoeuvre shortest_dubins(const Pose& from, const Pose& to, double radius_m);

}  // namespace tramline
