#pragma once
// One job of a file of logs: what belongs together of it.

#include <limits>
#include <string>
#include <vector>

#include "tramline/io/fixes/log_entry.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

struct LogJob {
  WorkLog log;
  std::vector<LogEntry> entries;     ///< the logs it is made of; none for files that are one log
  std::vector<std::string> devices;  ///< as the file calls them
  Clock clock = Clock::kNone;        ///< of the log, also where that was moved away
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< see WorkLog::clock
  double to_s = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline::io
