#pragma once
// One time log of an ISOXML task set (ISO 11783-10, annex D).

#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/isoxml/task_data.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Reads one time log from its two files. `elements`: those of all devices, may be empty. The fixes have no
/// heading and no speed, because time logs do not contain them. Records without a possible position are
/// skipped. Throws bad_input for a header that cannot be read or that names no positions. The result may have
/// no fixes. O(size).
WorkLog decode_time_log(std::string_view header_xml, std::string_view records,
                        const std::vector<DeviceElement>& elements, const std::string& place);

}  // namespace tramline::io
