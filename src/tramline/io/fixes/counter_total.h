#pragma once
// The increase of a machine's counter over a log.

#include <optional>

namespace tramline::io {

/// Sums the increase of a counter that continues from its value before the log and may be reset.
class CounterTotal {
 public:
  /// Adds a reading; negative readings and NaN are ignored.
  void add(double reading);
  /// NaN before the second reading.
  double total() const;

 private:
  std::optional<double> last_;
  std::optional<double> total_;
};

}  // namespace tramline::io
