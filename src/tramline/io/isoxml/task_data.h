#pragma once
// The machines and tasks of TASKDATA.XML, as plain values.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/log_job.h"
#include "tramline/io/isoxml/task_files.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// Data dictionary identifiers of ISO 11783-11 that are read.
namespace ddi {
inline constexpr unsigned kActualWidth = 67, kDefaultWidth = 68, kMostWidth = 70, kOffsetX = 134,
                          kOffsetY = 135, kVolumeRate = 2, kMassRate = 7, kCountRate = 12, kWorkState = 141,
                          kFirstCondensed = 161, kLastCondensed = 176, kTotalArea = 116, kTotalDistance = 117,
                          kTotalTime = 119;
}

/// Part of a machine (element DET).
struct DeviceElement {
  std::string id;        ///< "DET-1"
  std::string device;    ///< of the device it belongs to
  unsigned type = 0;     ///< 1 device, 2 function, 4 section, 5 unit …
  long long number = 0;  ///< within the device; sections are numbered by it
  long long parent = 0;  ///< object id
  long long object = 0;
  std::map<unsigned, long long> properties;  ///< fixed values (DPT) by identifier
};

struct TaskData {
  std::vector<DeviceElement> elements;
  std::map<std::string, std::string> device_names;  ///< designators by id
  std::vector<LogEntry> logs;                       ///< in the order of the tasks
  RawDataset partfields;  ///< layers "partfields" and "obstacles", without those that are empty
  RawDataset guidance;    ///< layer "guidance", unless it is empty
};

/// Returns the text of an external file by its name; nullopt where there is none.
using ExternalFile = std::function<std::optional<std::string>(const std::string&)>;

/// Reads the text of a TASKDATA.XML. `path`: of the task set, for messages. Throws bad_input like
/// read_task_data(). O(size).
TaskData parse_task_data(std::string_view xml, const ExternalFile& external, const std::string& path);

/// Reads TASKDATA.XML and the external files it names (XFR). Throws bad_input, naming the file, for damaged
/// XML and for a named external file that is missing. Without a TASKDATA.XML the result is empty. O(size).
TaskData read_task_data(const TaskFiles& files);

}  // namespace tramline::io
