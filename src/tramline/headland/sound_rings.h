#pragma once
// Is a pass one that a machine can drive? Looked at from its path alone.

#include <vector>

#include "tramline/headland/turning_land.h"

namespace tramline {

/// Does the path keep its distance from the shores, up to 2e-7 m?
bool keeps_off(const Path& path, const std::vector<Shore>& shores);

/// Are the closed paths on the land, nowhere tighter than its radius nor kinked, and do none of them meet or
/// cross itself or another? O(n² + n·m) for n segments and m edges of shores.
bool are_sound(const std::vector<Path>& paths, const TurningLand& land);

}  // namespace tramline
