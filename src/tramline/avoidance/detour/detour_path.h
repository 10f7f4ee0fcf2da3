#pragma once
// The path round obstacles on one side of a track: an arc away from the track, along the drivable hull
// of what is in the way, and an arc back.

#include <optional>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// A disc the path may not enter. In the frame of a detour: x along the track, y to the side of passing,
/// the track being y = 0.
struct KeepOut {
  Point centre;
  double radius = 0;
};

/// Treatment of a hull's corners by a path.
enum class HullCorners {
  kDrivable,   ///< room is made for arcs of the path's radius
  kAsTheyAre,  ///< discs keep their own radii, all equal: the path may be tighter there (Versleijen fig. 19)
};

/// The detour with the least displacement and the earliest return: arcs and lines with radii of at least
/// `radius_m`, leaving and rejoining y = 0 tangentially, outside all discs. In the detour's frame.
///
/// Round one disc of radius ρ at (0, c) it has three arcs. Its peak is h = ρ + c; its half-length is
///   √((ρ + r)² − (r − c)²)   where ρ ≥ r (Versleijen fig. 18; c with its sign on the passing side), and
///   √(4rh − h²)              where ρ < r: the middle arc then has radius r and touches the disc at the peak.
/// Round several it follows their drivable hull: each disc pressed from within against a disc of radius
/// max(r, ρ), all with the same peak, and the upper convex hull of those.
///
/// nullopt where no disc reaches over the track (there is nothing to drive round). Where the hull rises so
/// steeply that an arc to it would turn by more than a right angle, a line leads up to it. Precondition: at
/// least one disc, radius_m > 0. O(n log n). With kAsTheyAre it may be tighter than `radius_m` in the middle
/// (Versleijen §4.2.2): see smallest_radius().
std::optional<Path> detour_path(const std::vector<KeepOut>& discs, double radius_m,
                                HullCorners corners = HullCorners::kDrivable);

}  // namespace tramline
