#pragma once
// The amount that a machine applies in a step.

#include "tramline/coverage/dose/dose_settings.h"
#include "tramline/coverage/drive/worked_step.h"

namespace tramline::coverage {

/// Rates are amounts per hectare.
inline constexpr double kHectare_m2 = 1e4;

/// The amount of one quad of a step for each metre across the machine where the pattern is 1.
struct QuadAmount {
  double per_m = 0;
  bool logged = false;
};

/// A nozzle emits an amount per time onto the land it passes over in that time. At the rate R the machine
/// applies R · way for each metre across it, where the way is that of the middle of the working sections: in
/// a bend the inside gets more for its area, the outside less. Without rate control it applies R · nominal
/// speed · time instead, standing or driving. A logged rate holds from half way after the fix before to half
/// way to the next, as the states of sections do. `per_m` is NaN where no rate is known. O(1).
QuadAmount amount_of(const WorkedStep& step, const QuadOrigin& origin, const RateSettings& rates);

}  // namespace tramline::coverage
