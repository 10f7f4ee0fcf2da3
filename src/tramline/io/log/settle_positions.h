#pragma once
// From the coordinates of a table to positions.

#include <string>

#include "tramline/io/log/columns.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Decides on the frame of a log's positions and sets WorkLog::positions. With a CRS (LogOptions::crs) they
/// are projected to longitude and latitude; "none" is plain metres. Without, the names decide; where they
/// leave it open, coordinates that span more than two degrees, or of which more than one in a hundred is
/// impossible as longitude and latitude, are metres. Then skips what is impossible and what is far from the
/// rest of the log. Throws bad_input for a CRS that is not known, and when no position is left. O(fixes).
void settle_positions(WorkLog& log, PositionNames names, const std::string& crs, const std::string& place);

/// Places of one log do not span more, degrees: beyond this it has strays, or is in metres.
inline constexpr double kWidestLog_deg = 2;

}  // namespace tramline::io
