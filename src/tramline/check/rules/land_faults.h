#pragma once

#include <string>

#include "tramline/check/verify.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// Appends a violation of `rule` where `wrong` is land of more than `tolerance_m2`, placed on its largest
/// part. `what`: a format string with one field, for the area in m².
void report_land(Rule rule, const Region& wrong, double tolerance_m2, const std::string& what,
                 Violations& out);

}  // namespace tramline::check
