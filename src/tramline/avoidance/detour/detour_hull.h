#pragma once
// The drivable hull of what is in the way, and the path along it. In the frame of a detour.

#include <numbers>
#include <vector>

#include "tramline/avoidance/detour/detour_path.h"

namespace tramline {

/// Discs of one radius whose centres form the upper side of a convex polygon, left to right.
struct Hull {
  std::vector<Point> centres;
  double radius = 0;
};

/// The hull that a path with arcs of at least `radius_m` follows. All its discs have the largest of the
/// radii, and that of the path where corners are to be drivable: every disc lies within one of those, which
/// touches it at its highest point. Precondition: at least one disc. O(n log n).
Hull hull_round(const std::vector<KeepOut>& discs, double radius_m, HullCorners corners);
/// Left and right exchanged.
Hull mirrored(Hull hull);

/// The way of the path back from the hull to the track. Mirrored along the track the way there is the same
/// problem.
struct Approach {
  std::size_t vertex = 0;  ///< of the hull, where the path leaves it
  Point normal;            ///< unit, outward, where the path leaves the hull
  Point arc_centre;        ///< of the arc back to the track; a line may lead to it
  Point on_track;          ///< where that arc ends
};
Approach mirrored(Approach approach, const Hull& hull);

/// Angle of the steepest line back to the track, rad.
inline constexpr double kSteepest = 75 * std::numbers::pi / 180;
/// A descending line of the steepest slope that touches the hull: the outward normal there, the vertex, and
/// the line's distance from the origin. The caller fills in the arc's centre and end.
struct SteepLine {
  Approach touching;
  double off_m = 0;
};
SteepLine steepest_line(const Hull& hull);

/// The path from the track round the hull and back, arcs of radius `arc` at both ends. Segments shorter than
/// a nanometre are left out. Precondition: in.vertex <= out.vertex.
Path hull_path(const Hull& hull, const Approach& in, const Approach& out, double arc);

}  // namespace tramline
