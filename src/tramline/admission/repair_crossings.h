#pragma once
// Step 5: rings that touch or cross themselves.

#include "tramline/admission/repair_log.h"
#include "tramline/admission/work_ring.h"

namespace tramline {

/// What the land within a ring is to its field.
enum class RingRole { kOuter, kHole };

/// The land a ring encloses, by the even-odd rule: the ring itself when it is simple; otherwise its lobes,
/// largest first, with the land they enclose but do not contain as holes. Lobes without area are left out,
/// lobes of an outer ring below guess_limit_m2 too, each noted. The repair's area change is measured against
/// the ring's shoelace area, and counts the other way for a hole. Throws a refusal naming the
/// place where even-odd and non-zero rule differ by more than guess_limit_m2: deciding would be guessing.
/// A ring that crosses itself more than 2,000 times is refused before anything is made of it.
/// Precondition: at least three points.
Region repair_crossings(const WorkRing& ring, RingRole role, RepairLog& repair_log);

}  // namespace tramline
