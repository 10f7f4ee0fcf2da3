#pragma once
// The logs of a file, and its jobs: groups of logs that belong together.

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
  std::string field_id;   ///< partfield it was recorded on: "PFD-2"; empty if the task names none
};

/// The logs of a file that belong together.
struct LogJob {
  WorkLog log;
  std::vector<LogEntry> entries;     ///< the logs it consists of; empty for files that are one log
  std::vector<std::string> devices;  ///< names of the devices in the file
  Clock clock = Clock::kNone;        ///< clock of the log, kept when `log` has been moved out
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< see WorkLog::clock
  double to_s = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline::io
