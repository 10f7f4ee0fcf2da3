#pragma once
// Converts the coordinates of a table to positions.

#include <string>

#include "tramline/io/log/columns.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Decides on the frame of a log's positions and sets WorkLog::positions. With a CRS (LogOptions::crs) they
/// are projected to longitude and latitude; "none" is plain metres. Without a CRS the names decide; where
/// they are ambiguous, coordinates that span more than two degrees, or of which more than one in a hundred is
/// impossible as longitude and latitude, are metres. Then skips impossible positions and those far from the
/// rest of the log. Throws bad_input for an unknown CRS, and when no position remains. O(fixes).
void settle_positions(WorkLog& log, PositionNames names, const std::string& crs, const std::string& place);

/// The largest span of the positions of one log, degrees: beyond this it has strays, or is in metres.
inline constexpr double kWidestLog_deg = 2;

}  // namespace tramline::io
