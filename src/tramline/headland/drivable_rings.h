#pragma once
// Is a pass one that a machine can drive? Looked at from its path alone.

#include <vector>

#include "tramline/headland/turning_room.h"

namespace tramline {

/// Does the path keep its distance from the offset_boundaries, up to kNearerPass_m?
bool keeps_off(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries);

/// Is the closed path on the land, nowhere tighter than its radius nor kinked? O(n·m) for n segments and m
/// edges of offset_boundaries.
bool can_be_driven(const Path& path, const TurningRoom& land);

/// How many pairs of segments meet, of those not joined end to end: 0 where no path meets itself or another.
/// O(n²).
int meeting_places(const std::vector<Path>& paths);

/// The path cut before every segment that meets one driven before, so that no part meets itself; the path
/// itself where it does not. O(n²).
std::vector<Path> parted_where_it_meets_itself(const Path& path);

}  // namespace tramline
