#pragma once
// The logs of a file, and its jobs: which of them belong together.

#include <limits>
#include <string>
#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// One log of a file that may hold several.
struct LogEntry {
  std::string name;       ///< for LogOptions::log: "TLG00001"; empty for files that are one log
  std::string task_id;    ///< "TSK1"; empty outside task sets
  std::string task_name;  ///< designator of the task
  std::string field_id;   ///< partfield it was recorded on: "PFD-2"; empty when the task names none
};

/// What belongs together of a file of logs.
struct LogJob {
  WorkLog log;
  std::vector<LogEntry> entries;     ///< the logs it is made of; none for files that are one log
  std::vector<std::string> devices;  ///< as the file calls them
  Clock clock = Clock::kNone;        ///< of the log, also where that was moved away
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< see WorkLog::clock
  double to_s = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline::io
