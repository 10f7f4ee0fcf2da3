#pragma once
// Determines the unit of widths of a table that does not name it.

#include <cstddef>
#include <span>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// The distance column of one record, in the unit of the table.
struct RecordedDistance {
  std::size_t record = 0;
  double distance = 0;
};

/// Scales the booms of a log whose table names no unit of its widths. Such tables often have a distance since
/// the last record in the same system of units beside it; the length of one unit of distance in metres,
/// computed from the positions (median over steps of one unit), is then the unit of the widths too: metres,
/// feet, inches, centimetres or millimetres to 5 %. Without distances, or where they fit none of these,
/// metres. Says what it did in the log's notes, and returns the unit, m. Preconditions: positions are final;
/// `distances` ascend by record. O(fixes · log).
double settle_width_unit(WorkLog& log, std::span<const RecordedDistance> distances);

}  // namespace tramline::io
