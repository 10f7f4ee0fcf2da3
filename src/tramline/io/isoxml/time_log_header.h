#pragma once
// The header of a time log (TLG00001.xml): the contents of each record of the .bin.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tramline::io {

/// Parts of a position, in the order of a record (ISO 11783-10, D.2 and the element PTN).
enum class PositionPart { kNorth, kEast, kUp, kStatus, kPdop, kHdop, kSatellites, kGpsTime, kGpsDate };
inline constexpr std::size_t kPositionParts = 9;

/// One logged value (element DLV).
struct LoggedValue {
  unsigned ddi = 0;
  std::string element;             ///< "DET-1"
  std::optional<long long> fixed;  ///< value given in the header itself and not in the records
};

struct TimeLogHeader {
  bool has_position = false;
  std::array<bool, kPositionParts> in_record{};  ///< attribute present but empty
  std::optional<double> fixed_lat_deg, fixed_lon_deg;
  std::vector<LoggedValue> values;  ///< a record refers to them by index
};

/// Reads the XML. Throws bad_input, beginning with `place`, for damaged XML, for one without a TIM element or
/// without times in the records, and for more values than a record can number.
TimeLogHeader read_time_log_header(std::string_view xml, const std::string& place);

}  // namespace tramline::io
