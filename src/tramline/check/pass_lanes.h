#pragma once
// The swath of a headland pass as lanes.

#include <vector>

#include "tramline/check/lane.h"
#include "tramline/model/headland.h"

namespace tramline::check {

/// Lanes that make up the swath of a pass: of a closed one, one. An open one ends flat at both ends, so its
/// last metres there are lanes of their own.
/// Precondition: the pass has no fault (check_headland).
std::vector<Lane> pass_lanes(const HeadlandPass& pass, double width_m);

}  // namespace tramline::check
