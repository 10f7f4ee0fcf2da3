#pragma once
// Tests of whether a machine can drive a pass, from its path alone.

#include <vector>

#include "tramline/headland/turning_room.h"

namespace tramline {

/// Whether the path keeps its distance from the offset boundaries, up to kNearerPass_m.
bool keeps_off(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries);

/// Whether the closed path lies on the land, nowhere tighter than its radius and without kinks. O(n·m) for n
/// segments and m edges of the offset boundaries.
bool can_be_driven(const Path& path, const TurningRoom& land);

/// Number of pairs of segments that meet, of those not joined end to end: 0 where no path meets itself or
/// another. O(n²).
int meeting_count(const std::vector<Path>& paths);

/// The path cut before every segment that meets an earlier one, so that no part meets itself; the path itself
/// where it does not. O(n²).
std::vector<Path> parted_where_it_meets_itself(const Path& path);

}  // namespace tramline
