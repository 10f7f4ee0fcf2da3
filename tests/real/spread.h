#pragma once
// How figures of many fields are spread.

#include <algorithm>
#include <cmath>
#include <vector>

namespace tramline::testing {

/// 0 of no values.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// The least of the values that so large a share of them does not exceed; 0 of no values.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double count = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(1.0, count)) - 1];
}

struct Spread {
  double least = 0;
  double median = 0;
  double most = 0;
};

/// All 0 of no values.
inline Spread spread_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {*std::min_element(values.begin(), values.end()), median(values),
          *std::max_element(values.begin(), values.end())};
}

}  // namespace tramline::testing
