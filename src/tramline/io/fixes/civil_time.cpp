#include "tramline/io/fixes/civil_time.h"

#include <array>
#include <chrono>

#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

/// Three numbers with the same sign between them.
std::optional<std::array<long long, 3>> three_numbers(std::string_view text, char sign) {
  const std::size_t first = text.find(sign);
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find(sign, first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  const auto a = digits_in(text.substr(0, first));
  const auto b = digits_in(text.substr(first + 1, second - first - 1));
  const auto c = digits_in(text.substr(second + 1));
  if (!a || !b || !c) return std::nullopt;
  return std::array{*a, *b, *c};
}

/// "+02:00", "-0530", "+02"; seconds that local time is ahead.
std::optional<double> zone_s(std::string_view text) {
  const double sign = text.front() == '-' ? -1 : 1;
  text.remove_prefix(1);
  const std::size_t colon = text.find(':');
  const auto hours = digits_in(text.substr(0, 2));
  const std::string_view rest =
      colon == 2 ? text.substr(3) : text.substr(std::min<std::size_t>(2, text.size()));
  const auto minutes = rest.empty() ? std::optional<long long>(0) : digits_in(rest);
  if (!hours || !minutes || *hours > 14 || *minutes > 59 || text.size() < 2) return std::nullopt;
  return sign * (3600.0 * static_cast<double>(*hours) + 60.0 * static_cast<double>(*minutes));
}

}  // namespace

std::optional<long long> days_to(long long year, long long month, long long day) {
  if (year < 1900 || year > 9999 || month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

std::optional<double> time_of_day_s(std::string_view text) {
  text = trimmed(text);
  const std::size_t first = text.find(':');
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find(':', first + 1);
  const auto hours = digits_in(text.substr(0, first));
  const auto minutes =
      digits_in(text.substr(first + 1, second == std::string_view::npos ? second : second - first - 1));
  const auto seconds =
      second == std::string_view::npos ? std::optional<double>(0) : number_in(text.substr(second + 1));
  if (!hours || !minutes || !seconds) return std::nullopt;
  if (*hours > 24 || *minutes > 59 || *seconds < 0 || *seconds >= 61) return std::nullopt;
  return 3600.0 * static_cast<double>(*hours) + 60.0 * static_cast<double>(*minutes) + *seconds;
}

std::optional<long long> date_days(std::string_view text) {
  text = trimmed(text);
  for (const char sign : {'-', '/'})
    if (const auto date = three_numbers(text, sign)) return days_to((*date)[0], (*date)[1], (*date)[2]);
  if (const auto date = three_numbers(text, '.')) return days_to((*date)[2], (*date)[1], (*date)[0]);
  return std::nullopt;
}

std::optional<double> date_time_s(std::string_view text) {
  text = trimmed(text);
  const std::size_t split = text.find_first_of("T ");
  const auto days = date_days(text.substr(0, split));
  if (!days) return std::nullopt;
  const double midnight = kDay_s * static_cast<double>(*days);
  if (split == std::string_view::npos) return midnight;
  std::string_view clock = trimmed(text.substr(split + 1));
  double zone = 0;
  if (clock.ends_with('Z') || clock.ends_with('z')) {
    clock.remove_suffix(1);
  } else if (const std::size_t sign = clock.find_first_of("+-"); sign != std::string_view::npos) {
    const auto ahead = zone_s(clock.substr(sign));
    if (!ahead) return std::nullopt;
    zone = *ahead;
    clock = clock.substr(0, sign);
  }
  const auto time = time_of_day_s(clock);
  if (!time) return std::nullopt;
  return midnight + *time - zone;
}

}  // namespace tramline::io
