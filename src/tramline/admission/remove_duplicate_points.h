#pragma once
// Step 2: removes consecutive vertices at the same position.

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"

namespace tramline {

/// Removes every vertex within kSamePlace_m of the one before it (round the end too) and notes each. O(n).
void remove_duplicate_points(WorkRing& ring, RepairLog& repair_log);

}  // namespace tramline
