#pragma once
// The number of detours of a plan, and their smallest radius.

#include <limits>

#include "tramline/model/plan.h"

namespace tramline {

struct DetourSummary {
  int left = 0;   ///< pass their obstacles on the left, in driving direction
  int right = 0;  ///< pass them on the right
  double smallest_radius_m = std::numeric_limits<double>::infinity();  ///< infinite without detours

  int count() const { return left + right; }
};

DetourSummary summary_of_detours(const Plan& plan);

}  // namespace tramline
