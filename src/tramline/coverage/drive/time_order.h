#pragma once
// Logs whose records are not in order of time.

#include <cstddef>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// How many fixes are earlier than the one before them, unit by unit. O(n).
std::size_t out_of_order(const WorkLog& log);

/// Fixes in order of time, those of the same time as they were; a fix without a time stays behind the one
/// before it. O(n log n).
WorkLog in_time_order(WorkLog log);

}  // namespace tramline::coverage
