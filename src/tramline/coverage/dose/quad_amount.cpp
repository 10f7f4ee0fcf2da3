#include "tramline/coverage/dose/quad_amount.h"

#include <algorithm>
#include <cmath>

namespace tramline::coverage {
namespace {

/// The rate over a part of a step, each half of which has the rate of its end; where only one is known, that.
double logged_rate(const WorkedStep& step, const QuadOrigin& origin) {
  const double before = step.rate_before_per_ha, after = step.rate_after_per_ha;
  if (std::isnan(before)) return after;
  if (std::isnan(after)) return before;
  const double first = std::max(0.0, std::min(origin.until, 0.5) - origin.from);
  const double second = std::max(0.0, origin.until - std::max(origin.from, 0.5));
  return first + second > 0 ? (first * before + second * after) / (first + second) : before;
}

}  // namespace

QuadAmount amount_of(const WorkedStep& step, const QuadOrigin& origin, const RateSettings& rates) {
  const double share = origin.until - origin.from;
  const double logged =
      rates.use_logged ? logged_rate(step, origin) : std::numeric_limits<double>::quiet_NaN();
  if (!std::isnan(logged)) return {logged / kHectare_m2 * step.way_m * share, true};
  const double way_m =
      std::isnan(rates.nominal_speed_mps) ? step.way_m : rates.nominal_speed_mps * step.seconds;
  return {rates.nominal_per_ha / kHectare_m2 * way_m * share, false};
}

}  // namespace tramline::coverage
