#include "tramline/io/log/time_column.h"

#include <limits>

#include "tramline/io/fixes/civil_time.h"
#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

// Seconds since 1970 are above this since 1973, and milliseconds above the other.
constexpr double kLeastEpoch_s = 1e8, kLeastEpoch_ms = 1e11;

}  // namespace

std::optional<double> TimeColumn::read(Kind kind, std::string_view time, std::string_view date) const {
  switch (kind) {
    case Kind::kDateTime:
      return date_time_s(time);
    case Kind::kDateAndTime: {
      const auto days = date_days(date);
      const auto of_day = time_of_day_s(time);
      if (!days || !of_day) return std::nullopt;
      return kDay_s * static_cast<double>(*days) + *of_day;
    }
    case Kind::kOfDay:
      return time_of_day_s(time);
    case Kind::kNumber:
      return number_in(time);
    case Kind::kNone:
      break;
  }
  return std::nullopt;
}

double TimeColumn::time_s(std::string_view time, std::string_view date) {
  if (kind_ == Kind::kNone) {
    for (const Kind kind : {Kind::kNumber, Kind::kDateTime, Kind::kDateAndTime, Kind::kOfDay}) {
      const auto value = read(kind, time, date);
      if (!value) continue;
      kind_ = kind;
      if (kind == Kind::kNumber) {
        if (number_factor_ == 0) number_factor_ = *value >= kLeastEpoch_ms ? 1e-3 : 1;
        since_1970_ = *value * number_factor_ >= kLeastEpoch_s;
      }
      last_of_day_s_ = *value;
      break;
    }
  }
  const auto value = read(kind_, time, date);
  if (!value) return std::numeric_limits<double>::quiet_NaN();
  if (kind_ == Kind::kNumber) return *value * number_factor_;
  if (kind_ != Kind::kOfDay) return *value;
  // Half a day back is midnight; less is a record out of order.
  if (last_of_day_s_ - *value > 0.5 * kDay_s) days_s_ += kDay_s;
  last_of_day_s_ = *value;
  return days_s_ + *value;
}

Clock TimeColumn::clock() const {
  switch (kind_) {
    case Kind::kNone:
      return Clock::kNone;
    case Kind::kOfDay:
      return Clock::kOfDay;
    case Kind::kNumber:
      return since_1970_ ? Clock::kUtc : Clock::kOther;
    default:
      return Clock::kUtc;
  }
}

}  // namespace tramline::io
