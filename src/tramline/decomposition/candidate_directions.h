#pragma once
// The directions that the sweep tries (Versleijen §2.2.2).

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/field.h"

namespace tramline {

/// Every distinct edge direction of the outer ring and of the obstacles (not of passable ones), in
/// increasing order, modulo 180 degrees. O(n log n).
std::vector<Direction> candidate_directions(const Field& field);

}  // namespace tramline
