#pragma once
// Adds obstacles from other files to a field.

#include <vector>

#include "tramline/admission/read_obstacles.h"
#include "tramline/model/field.h"

namespace tramline {

/// Adds the obstacles that intersect the field to field.obstacles: lines widened to `size_m` with flat ends,
/// points as axis-parallel squares of `size_m`, everything cut to the outer ring, overlapping ones united,
/// and passable land less the land of real obstacles. `used` (one flag per obstacle) is set for those used;
/// the others lie elsewhere. Repairs of the obstacles' own rings go to field.repairs (with positions in
/// longitude and latitude, or plain metres). Throws bad_input when obstacles cover the whole field.
/// O(obstacles) box tests, and O(n log n) per obstacle used.
void place_obstacles(Field& field, const std::vector<LooseObstacle>& obstacles, double size_m,
                     std::vector<char>& used);

}  // namespace tramline
