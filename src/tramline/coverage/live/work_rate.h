#pragma once
// The present rate of work.

#include <deque>
#include <limits>

namespace tramline::coverage {

/// The rate is computed over this much driving time, s.
inline constexpr double kRateWindow_s = 300;

/// Land gained per time driven, over the last kRateWindow_s of driving: turns count, breaks do not.
class WorkRate {
 public:
  /// `longest_s`: longer gaps between fixes are breaks.
  explicit WorkRate(double longest_s) : longest_s_(longest_s) {}

  /// Adds the area worked up to this fix, m². O(1) amortised.
  void add(double time_s, double worked_m2);
  /// The rate; NaN without times, and before the first ten seconds.
  double m2_per_s() const;

 private:
  struct Sample {
    double driven_s = 0;
    double worked_m2 = 0;
  };
  double longest_s_;
  double last_s_ = std::numeric_limits<double>::quiet_NaN();
  double driven_s_ = 0;
  double worked_m2_ = 0;
  std::deque<Sample> samples_;  ///< a second apart at least
};

}  // namespace tramline::coverage
