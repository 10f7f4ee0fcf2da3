#pragma once
// Calendar dates and times of day as logs write them.

#include <optional>
#include <string_view>

namespace tramline::io {

inline constexpr double kDay_s = 86400;

/// Days from 1970-01-01 to a date of the Gregorian calendar; nullopt when there is no such date. Years 1900
/// to 9999.
std::optional<long long> days_to(long long year, long long month, long long day);

/// "17:30:20.5", "17:30", seconds since midnight. A leap second counts as the second after.
std::optional<double> time_of_day_s(std::string_view text);

/// "2020-01-02", "2020/01/02", "02.01.2020", days from 1970-01-01.
std::optional<long long> date_days(std::string_view text);

/// Date and time of day with "T" or a blank between, and Z, "+02:00", "+0200" or "+02" after them or nothing:
/// seconds from 1970-01-01T00:00. A date alone is its midnight.
std::optional<double> date_time_s(std::string_view text);

}  // namespace tramline::io
