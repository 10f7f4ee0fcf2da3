#include "tramline/model/rate_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

constexpr double kHour_s = 3600;

}  // namespace

SecondPrices second_prices(const Rates& rates) {
  const double fuel = rates.fuel_l_per_h * rates.fuel_price;
  return {(rates.price_per_hour + fuel) / kHour_s, (rates.price_per_hour + kIdleFuelShare * fuel) / kHour_s};
}

double stop_seconds(const Rates& rates) {
  const double second = second_prices(rates).work_off;
  return second > 0 ? std::min(kLongestStop_s, rates.price_per_stop / second) : 0;
}

double driven_over_seconds_per_m(const Rates& rates) {
  const double second = second_prices(rates).work_off;
  return second > 0 ? driven_over_price_per_m(rates) / second : 0;
}

std::string fault_of(const RateNumber& number, double value) {
  // Written so that NaN is a fault.
  const bool in_range = value >= number.least && value <= number.most;
  if (in_range && !(number.whole && value != std::floor(value))) return "";
  return fmt::format("is {:g}, but must be {}at least {:g} and at most {:g} {}", value,
                     number.whole ? "a whole number, " : "", number.least, number.most, number.unit);
}

std::string rates_fault(const Rates& rates) {
  for (const RateNumber& number : kRateNumbers) {
    const double value = rates.*number.value;
    if (value < 0) continue;
    if (const std::string fault = fault_of(number, value); !fault.empty())
      return fmt::format("{} {}", number.key, fault);
  }
  return "";
}

std::string operation_words() {
  std::string out;
  for (int i = 0; i <= static_cast<int>(Operation::kDrone); ++i)
    out += fmt::format("{}{}", i == 0 ? "" : ", ", name(static_cast<Operation>(i)));
  return out;
}

}  // namespace tramline
