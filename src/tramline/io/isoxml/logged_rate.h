#pragma once
// The applied rate of a time log.

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The first rate logged for the relevant elements, or failing that for any: volume, mass or number per area
/// (2, 7, 12). It holds until another is recorded.
class LoggedRate {
 public:
  LoggedRate(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);

  void update(const TimeLogRecord& record);
  /// The rate per hectare; NaN where none is known.
  double per_ha() const;
  AmountUnit unit() const;
  /// A note where several rates are logged; else empty.
  const std::string& note() const { return note_; }

 private:
  std::optional<std::size_t> index_;  ///< in the header
  unsigned ddi_ = 0;
  std::optional<double> value_;
  std::string note_;
};

}  // namespace tramline::io
