#pragma once
// The swath of a headland pass as swaths.

#include <vector>

#include "tramline/check/measure/swath_clearance.h"
#include "tramline/model/headland.h"

namespace tramline::check {

/// Lanes that make up the swath of a pass: of a closed one, one. An open one ends flat at both ends, so its
/// last metres there are swaths of their own.
/// Precondition: the pass has no fault (check_headland).
std::vector<SwathClearance> pass_clearances(const HeadlandPass& pass, double width_m);

}  // namespace tramline::check
