#pragma once
// Logs whose records are not in order of time.

#include <cstddef>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The number of fixes that are earlier than the previous fix of their unit. O(n).
std::size_t out_of_order(const WorkLog& log);

/// The log with fixes in order of time; those of the same time keep their order, and a fix without a time
/// stays after the one before it. O(n log n).
WorkLog in_time_order(WorkLog log);

}  // namespace tramline::coverage
