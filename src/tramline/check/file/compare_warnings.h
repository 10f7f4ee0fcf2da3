#pragma once

#include <vector>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Does the plan warn of what there is to warn of, with the right figures, and of nothing else that can be
/// told from it: land that stays unworked, swaths beyond the boundary, land given up, headland passes without
/// room, tracks that are none, dropped and short pieces, and what was said of the field? Figures may be off
/// by one in their last digit. Rule "warnings". Nothing is asked of files of earlier versions.
/// Precondition: verify(plan).complete. O(v·n) for v vertices of overlap and n of the field.
std::vector<Violation> compare_warnings(const Plan& plan);

}  // namespace tramline::check
