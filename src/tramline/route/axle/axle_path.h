#pragma once
// The way of the axle while the implement works a piece or a pass.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"
#include "tramline/model/track.h"

namespace tramline {

/// The path driven forward: a stretch for each segment. O(n).
SteeredPath steered(const Path& path);

/// The part of a steered path between two positions along it, m. 0 ≤ from_m ≤ to_m ≤ length(path). O(n).
SteeredPath part_of(const SteeredPath& path, double from_m, double to_m);

/// The pose at a position along a path that has a stretch, m; beyond its ends straight on. O(n).
Pose pose_on(const SteeredPath& path, double at_m);

/// The way of the axle's middle from where the implement is at the path's start to where it is at the path's
/// end, as long as the path: along the path, and beyond its ends straight on. `path` has a length.
SteeredPath axle_path(const Path& path, const Turning& turning);
SteeredPath axle_path(const TrackPiece& piece, const Turning& turning);

/// The same for a closed path that is entered at a position along it: once round, from the pose in which it
/// begins back to that pose. `entered_m`: of the implement, 0 ≤ entered_m ≤ length.
SteeredPath closed_axle_path(const Path& path, double entered_m, const Turning& turning);

/// The pose in which a path that has a stretch ends.
Pose end_of(const SteeredPath& path);

/// The pose straight on from another, m; negative: straight back.
inline Pose moved_on(const Pose& pose, double by_m) {
  return {pose.at + by_m * pose.heading.unit(), pose.heading};
}

}  // namespace tramline
