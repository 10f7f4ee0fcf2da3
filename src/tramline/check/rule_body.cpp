#include <fmt/format.h>

#include "tramline/check/rules.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {

void check_body(const Case& c, Violations& out) {
  Region obstacles;
  for (const Obstacle& obstacle : c.plan.field.obstacles) obstacles.push_back(obstacle.shape);
  const Region expected = difference({{c.plan.field.outer, {}}}, unite(obstacles));
  const Region off = symmetric_difference(expected, c.plan.body);
  if (const double amount = area(off); amount > c.area_tolerance_m2)
    out.push_back({"body",
                   fmt::format("the body differs from the field less its obstacles by {:.3f} m²", amount),
                   place_on_largest(off), amount});

  const Region outside = difference(c.plan.given_up, expected);
  if (const double amount = area(outside); amount > c.area_tolerance_m2)
    out.push_back({"body", fmt::format("{:.3f} m² of the land given up lie outside the body", amount),
                   place_on_largest(outside), amount});
}

}  // namespace tramline::check
