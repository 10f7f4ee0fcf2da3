#pragma once
// Validates the positions of a log.

#include <string>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// The reason why this cannot be the longitude and latitude of a machine: "latitude 97.3 is impossible";
/// empty for a possible one. 0, 0 is written by receivers without a position.
std::string fault_of_lonlat(Point lonlat_deg);

/// Moves fixes more than two degrees from most of the log to `skipped`: no machine works that far apart, but
/// a damaged record can look intact. Logs in local metres are not changed. O(fixes).
void skip_strays(WorkLog& log);

}  // namespace tramline::io
