#pragma once

#include <vector>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Checks that the plan has all warnings that follow from it, with the right figures, and no others of these
/// kinds: land that stays unworked, swaths beyond the boundary, land given up, headland passes without room,
/// a plan without tracks, dropped and short pieces, and warnings about the field. Figures may be off by one
/// in their last digit; how much of the unworked land is narrow is not computed again. Rule "warnings". Files
/// of earlier versions are not checked. Precondition: verify(plan).complete. O(v·n) for v vertices of overlap
/// and n of the field.
std::vector<Violation> compare_warnings(const Plan& plan);

}  // namespace tramline::check
