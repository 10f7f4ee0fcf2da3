#pragma once
// Step 3: removes out-and-back edges without width.

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"

namespace tramline {

/// Removes vertices at which the ring turns back on itself so exactly (within kSamePlace_m) that the two
/// edges enclose nothing, until none is left, and notes each. Changes no area. O(n + n·spikes).
void remove_spikes(WorkRing& ring, RepairLog& repair_log);

}  // namespace tramline
