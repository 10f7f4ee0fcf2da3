#pragma once
// Reads the times of tables.

#include <optional>
#include <string_view>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Reads one time after the other. The first one that is understood decides what all are: date and time
/// (ISO 8601, with or without a zone; kUtc), seconds or milliseconds since 1970 (kUtc), a time of day
/// (kOfDay, counted on over midnight; kUtc with a date beside it), or a smaller number: seconds since a
/// an unknown moment (kOther).
class TimeColumn {
 public:
  /// `number_factor`: seconds in the unit of plain numbers, where the column's name gives it; 0: not known.
  explicit TimeColumn(double number_factor = 0) : number_factor_(number_factor) {}

  /// The time, s; NaN for a text that is empty or in a format other than that of the first.
  double time_s(std::string_view time, std::string_view date = {});
  Clock clock() const;

 private:
  enum class Kind { kNone, kDateTime, kDateAndTime, kOfDay, kNumber };

  std::optional<double> read(Kind kind, std::string_view time, std::string_view date) const;

  double number_factor_;
  Kind kind_ = Kind::kNone;
  double last_of_day_s_ = 0;
  double days_s_ = 0;
  bool since_1970_ = false;
};

}  // namespace tramline::io
