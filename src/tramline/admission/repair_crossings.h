#pragma once
// Step 5: repairs rings that touch or cross themselves.

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"

namespace tramline {

/// The role of a ring in its field.
enum class RingRole { kOuter, kHole };

/// The land a ring encloses, by the even-odd rule: the ring itself when it is simple; otherwise its lobes,
/// largest first, with the land they enclose but do not contain as holes. Lobes without area are left out,
/// lobes of an outer ring below guess_limit_m2 too, each noted. The repair's area change is relative to the
/// ring's shoelace area, with the opposite sign for a hole. Throws a refusal naming the position where
/// even-odd and non-zero rule differ by more than guess_limit_m2: a decision would be a guess. A ring that
/// crosses itself more than 2,000 times is refused without processing. Precondition: at least three points.
Region repair_crossings(const WorkRing& ring, RingRole role, RepairLog& repair_log);

}  // namespace tramline
