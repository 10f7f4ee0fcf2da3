#include <fmt/format.h>

#include <cmath>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// A towed implement may be beside its line by so much more than is stated, m.
constexpr double kMoreBeside_m = 0.01;

}  // namespace

void check_route_towing(const Case& c, Violations& out) {
  if (!tows(c.plan.machine.turning)) return;
  const std::vector<RouteLeg>& legs = c.plan.route.legs;
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    if (legs[i].work || legs[i].pass || !legs[i + 1].work) continue;
    const MachinePlace last = places_along(legs[i].path, c.plan.machine, kPoses_m).back();
    const double beside_m = std::abs(cross(last.ahead, last.implement - last.axle));
    if (beside_m > legs[i].lateral_error_m + kMoreBeside_m)
      out.push_back({Rule::kRouteLegs,
                     fmt::format("{} leaves the implement {:.3f} m beside its line, not {:.3f} m",
                                 leg_name(c.plan, i), beside_m, legs[i].lateral_error_m),
                     last.implement, beside_m});
  }
}

}  // namespace tramline::check
