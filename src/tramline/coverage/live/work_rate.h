#pragma once
// How fast the work goes at present.

#include <deque>
#include <limits>

namespace tramline::coverage {

/// The rate is that of so much driving, s.
inline constexpr double kRateWindow_s = 300;

/// Ground gained by the time driven, over the last kRateWindow_s of it: turns count, breaks do not.
class WorkRate {
 public:
  /// `longest_s`: longer gaps between fixes are breaks.
  explicit WorkRate(double longest_s) : longest_s_(longest_s) {}

  /// The ground worked up to this fix, m². O(1) amortised.
  void add(double time_s, double worked_m2);
  /// NaN without times, and before the first ten seconds.
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
