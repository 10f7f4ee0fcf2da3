#pragma once
// Tolerances of routes and of the order of tracks.

#include "tramline/turns/tolerances.h"

namespace tramline {

/// Tours whose lengths differ by no more than this count as equal, m: they are sums of thousands of hops.
inline constexpr double kLeastGain_m = 1e-6;
/// Orders of lines whose connections' times differ by no more than this count as equal, s: sums of thousands
/// of connections, of hours at the most.
inline constexpr double kSameTime_s = 1e-9;
/// The least width and height of a grid of points, m: all points may coincide.
inline constexpr double kLeastGridOfPlaces_m = 1e-6;

}  // namespace tramline
