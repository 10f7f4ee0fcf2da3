#pragma once
// Small logs to drive with.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/work_log.h"

namespace tramline::testing_logs {

/// A field from the origin to the north and east.
Region square(double side_m);

/// A boom of equal sections, from left to right, about the machine's middle.
Boom boom(int sections, double width_m);

/// A fix in local metres, at work, without a heading.
Fix fix(double time_s, Point at);
Fix fix(double time_s, Point at, double heading_deg);
/// Not at work.
Fix idle(Fix fix);
/// With some sections at work: "1100", from left to right.
Fix with_sections(Fix fix, const char* states);

/// Fixes of a machine of one section of the given width.
WorkLog log(std::vector<Fix> fixes, double width_m);

}  // namespace tramline::testing_logs
