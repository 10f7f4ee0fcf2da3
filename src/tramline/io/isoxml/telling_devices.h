#pragma once
// Which of the devices of a task set a time log is about.

#include <string>
#include <vector>

#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/time_log_header.h"

namespace tramline::io {

struct TellingDevices {
  std::vector<DeviceElement> elements;  ///< of the devices that count
  std::vector<std::string> devices;     ///< their ids; "" for elements that no device describes
  std::vector<std::string> notes;       ///< what was assumed, one sentence each
};

/// The devices of which the log has widths (67) or states (141, 161-176). Where several do, those count whose
/// width is known, and where the log is silent on when they work, the first that has states; where no width
/// is known, the one that the log tells most of. Elements that no device describes
/// count as one device, each a part of its own. O(elements + values, · log).
TellingDevices telling_devices(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);

}  // namespace tramline::io
