#include "tramline/coverage/live/work_rate.h"

namespace tramline::coverage {
namespace {

constexpr double kLeastTime_s = 10;

}  // namespace

void WorkRate::add(double time_s, double worked_m2) {
  const double gap_s = time_s - last_s_;  // NaN without times
  last_s_ = time_s;
  if (gap_s > 0 && gap_s <= longest_s_) driven_s_ += gap_s;
  worked_m2_ = worked_m2;
  if (!samples_.empty() && driven_s_ - samples_.back().driven_s < 1) return;
  samples_.push_back({driven_s_, worked_m2});
  while (samples_.size() > 2 && samples_[1].driven_s <= driven_s_ - kRateWindow_s) samples_.pop_front();
}

double WorkRate::m2_per_s() const {
  if (samples_.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double time_s = driven_s_ - samples_.front().driven_s;
  if (time_s < kLeastTime_s) return std::numeric_limits<double>::quiet_NaN();
  return (worked_m2_ - samples_.front().worked_m2) / time_s;
}

}  // namespace tramline::coverage
