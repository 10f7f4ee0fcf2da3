#pragma once
// Step 4: orients the rings.

#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// Makes the outer ring counter-clockwise and the holes clockwise. Noted as a repair where the format
/// prescribes that winding, and in any format for a hole that runs the same way as the
/// outer ring; otherwise formats differ and nothing was wrong. rings[0] is the outer ring.
void orient_rings(std::vector<WorkRing>& rings, RingWinding winding, RepairLog& repair_log);

}  // namespace tramline
