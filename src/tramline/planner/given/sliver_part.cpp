#include "tramline/planner/given/sliver_part.h"

#include <vector>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/tolerances.h"

namespace tramline {

bool is_sliver_part(const PlanningProblem& problem, const Polygon& part) {
  constexpr double kWidthTolerance_share = 0.01;
  if (area(part) < problem.settings.small_cell_m2) return true;
  const double width_m = problem.machine.width_m;
  const double across_m = 2 * largest_disc(part, 0.5 * kWidthTolerance_share * width_m).radius_m;
  return across_m < (1 - kWidthTolerance_share) * width_m;
}

void drop_specks(Region& region) {
  std::erase_if(region, [](const Polygon& polygon) { return area(polygon) < kNoGround_m2; });
}

}  // namespace tramline
