#pragma once
// The rings of one pass, drivable.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/worth/worth_driving.h"

namespace tramline {

/// Passes `number` round all boundaries that have that many. Boundaries are driven round one by one; where
/// the swaths would meet those of another boundary, or an obstacle without such a pass, they are driven round
/// together. Narrow passages are driven through where the land left otherwise is worth the land worked twice.
/// Rings that follow boundaries without such a pass are reduced to the parts worth driving (worth_driving),
/// or replaced by the parts worth driving of rings round the other boundaries, with ends where others are in
/// the way, if these are worth more. Where the field has no such pass none follows its boundary. `before`:
/// the passes with lower numbers.
std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number, const GroundToWork& to_work,
                                     const std::vector<HeadlandPass>& before);

}  // namespace tramline
