#pragma once
// How far a machine's counter got over a log.

#include <optional>

namespace tramline::io {

/// Counters run on from what they showed before the log began, and begin anew where somebody resets them.
class CounterTotal {
 public:
  /// A reading; negative ones and those that are no number are none.
  void add(double reading);
  /// NaN before the second reading.
  double total() const;

 private:
  std::optional<double> last_;
  std::optional<double> total_;
};

}  // namespace tramline::io
