#pragma once
// How long a detour is at least.

#include <vector>

#include "tramline/geometry/interval.h"

namespace tramline {

/// A point as a detour sees it, in the frame of its track.
struct SeenPoint {
  double along = 0;
  double aside = 0;  ///< how far it lies to the side on which the detour passes
};

/// The upper convex hull, by coordinates along. O(n log n).
std::vector<SeenPoint> upper_hull(std::vector<SeenPoint> points);

/// By how much a path is longer than its rows, m, at least: from the track and back to it within `rows`, past
/// all of the points by at least half_width_m on their far side. O(n log n).
double least_longer_m(const std::vector<SeenPoint>& points, double half_width_m, const Interval& rows);

}  // namespace tramline
