#pragma once
// The shortest ways from one pose to another for a machine that also reverses.

#include <vector>

#include "tramline/model/manoeuvre.h"

namespace tramline {

/// The 48 words of Reeds and Shepp (1990) between two poses, as far as they exist, the shortest first (of
/// equal ones in the order of the paper's families); the shortest of them is the shortest way of least radius
/// `radius_m` with changes of gear where they help. Arcs are of at most half a circle each. Parts without
/// length are left out, and what then repeats another word. Kind kReedsShepp, also of words without
/// reversing. Empty between equal poses: one word without stretches. Metres, frame of the poses. Ends in `to`
/// within 1e-9 of the distance and radius. The wheels are steered at once, at changes of gear while standing.
/// Precondition: radius_m > 0.
std::vector<Manoeuvre> reeds_shepp_words(const Pose& from, const Pose& to, double radius_m);

/// The length of the shortest of them, m, without building any. 0 between equal poses. O(1), allocates
/// nothing. Precondition: radius_m > 0.
double reeds_shepp_length(const Pose& from, const Pose& to, double radius_m);
/// A lower bound of that which takes a fraction of its time: the straight line, and the length of circle on
/// which the heading changes by as much. No way of least radius is shorter, whatever its gears. O(1).
double least_length(const Pose& from, const Pose& to, double radius_m);
/// The shortest of reeds_shepp_words(), without building the others. Precondition: radius_m > 0.
Manoeuvre shortest_reeds_shepp(const Pose& from, const Pose& to, double radius_m);

}  // namespace tramline
