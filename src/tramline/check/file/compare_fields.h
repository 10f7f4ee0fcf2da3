#pragma once

#include "tramline/check/verify.h"
#include "tramline/model/field.h"

namespace tramline::check {

/// Checks that the field of a plan is the field of the input: compares the outer rings and, by kind, the
/// obstacles as areas; each symmetric difference may be 1e-6 of the area compared. Both in local metres;
/// plain frames may have different origins, geodetic ones have to be the same (a violation otherwise).
/// Every violation has the rule "field", and its point is in the plan's frame.
/// Throws Error(kFailure) only where GEOS fails. O(v log v).
std::vector<Violation> compare_fields(const Field& planned, const Field& input);

}  // namespace tramline::check
