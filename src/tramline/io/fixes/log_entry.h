#pragma once
// One log of a file that may hold several.

#include <string>

namespace tramline::io {

struct LogEntry {
  std::string name;       ///< for LogOptions::log: "TLG00001"; empty for files that are one log
  std::string task_id;    ///< "TSK1"; empty outside task sets
  std::string task_name;  ///< designator of the task
  std::string field_id;   ///< partfield it was recorded on: "PFD-2"; empty when the task names none
};

}  // namespace tramline::io
