#pragma once
// Which positions a log can have.

#include <string>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Why this is no longitude and latitude of a machine: "latitude 97.3 is impossible"; empty when it can be
/// one. 0, 0 is what receivers write that know no position.
std::string fault_of_lonlat(Point lonlat_deg);

/// Moves the fixes to `skipped` that are more than two degrees from where most of the log is: no machine
/// works there and here, but a damaged record can look whole. Nothing happens to logs in local metres.
/// O(fixes).
void skip_strays(WorkLog& log);

}  // namespace tramline::io
