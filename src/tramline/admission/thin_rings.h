#pragma once
// Step 2: thins boundaries with far more corners than their shape needs.

#include <cstddef>
#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"

namespace tramline {

/// A polygon with no more corners than this, holes included, keeps every one of them.
inline constexpr std::size_t kManyCorners = 5000;

/// The most corners of a field, holes included.
inline constexpr std::size_t kMostCorners = 2 * kManyCorners;

/// Where the rings together have more than kManyCorners corners, removes corners so that each ring stays
/// within 1 cm of all removed corners, or within 2, 5 or 10 cm, whichever first results in no more than
/// kManyCorners; noted once for each ring that changes, with the change of its area. Throws a refusal that
/// names the numbers where even 10 cm leave more than kMostCorners. Time in proportion to the corners, memory
/// that of the rings.
void thin_rings(std::vector<WorkRing>& rings, RepairLog& repair_log);

}  // namespace tramline
