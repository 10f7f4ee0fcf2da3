#pragma once
// The devices of a task set to which a time log refers.

#include <string>
#include <vector>

#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/time_log_header.h"

namespace tramline::io {

struct LoggedDevices {
  std::vector<DeviceElement> elements;  ///< of the relevant devices
  std::vector<std::string> devices;     ///< their ids; "" for elements that no device describes
  std::vector<std::string> notes;       ///< the assumptions made, one sentence each
};

/// The devices for which the log has widths (67) or states (141, 161-176). Of several, those with a known
/// width are relevant and, if the log has no work states of them, the first one with states; where no width
/// is known, the device with the most logged values. Elements that no device describes count as one device,
/// each a separate part. O(elements + values, · log).
LoggedDevices logged_devices(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);

}  // namespace tramline::io
