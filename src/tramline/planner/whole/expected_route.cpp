#include "tramline/planner/whole/expected_route.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline {
namespace {

/// Where headlands are hardly as deep as turns, tracks at right angles to the edge cost a tenth of what
/// others behind the same passes cost beyond their floors: more than a part of the least tells nothing.
constexpr double kOfAny = 0.4;

}  // namespace

double least_beyond_floor(const ComparedPlans& plans) {
  double least = std::numeric_limits<double>::infinity();
  for (const ComparedPlan& other : plans)
    if (other.beyond_floor) least = std::min(least, *other.beyond_floor);
  return std::isfinite(least) ? kOfAny * least : 0;
}

}  // namespace tramline
