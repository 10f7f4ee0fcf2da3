#pragma once
// The path round obstacles on one side of a curved track: detour_path() for a track of lines and arcs.

#include <optional>
#include <vector>

#include "tramline/avoidance/detour/detour_path.h"
#include "tramline/geometry/path/measured_path.h"

namespace tramline {

/// A track in the frame of a detour: x roughly along it, y to the side of passing.
struct TrackLine {
  MeasuredPath measured;
  double blocked_from = 0;  ///< positions along the track between which the obstacle lies
  double blocked_to = 0;
};

struct CurvedDetourPath {
  Path path;
  double from = 0;  ///< positions along the track, of the two ends
  double to = 0;
};

/// As detour_path(): arcs and lines with radii of at least `radius_m`, outside all discs, leaving and
/// rejoining the track tangentially. The hull is that of detour_path(). An arc of radius r about the point
/// C(s), r to the side of passing from the position s on the track, touches the track there; it touches the
/// hull where the distance between C(s) and the polygon of the discs' centres is r + ρ. The first such
/// position outwards from what is in the way is used: it is approached by steps of half the missing distance,
/// which C(s) cannot exceed since the track is never tighter than r, and then found by bisection to 1e-12 m.
/// nullopt where nothing reaches over the track, the track ends before the detour does, or it bends away from
/// the frame's x by more than 75 degrees on the way. Preconditions: at least one disc; arcs of the track have
/// radii of at least radius_m > 0.
std::optional<CurvedDetourPath> curved_detour_path(const std::vector<KeepOut>& discs, double radius_m,
                                                   const TrackLine& track,
                                                   HullCorners corners = HullCorners::kDrivable);

}  // namespace tramline
