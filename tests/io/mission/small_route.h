#pragma once
// A plan with a route that is known by hand.

#include <numbers>

#include "support/refusals.h"
#include "support/small_plan.h"
#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/plan.h"

namespace tramline::testing_mission {

/// Along the first track to the east, half a circle of 1.5 m to the left, back along the second to (0, 4.5),
/// and 5 m out of it in reverse.
inline Plan plan_with_route() {
  Plan plan = testing_support::small_plan();
  const auto heading = [](double deg) { return Heading::clockwise_from_north(Angle::degrees(deg)); };
  const auto add = [&](LegKind kind, bool work, const SteeredStretch& stretch) {
    plan.route.legs.push_back({kind, stretch.gear, work, {stretch}});
  };
  add(LegKind::kWork, true, arc_from({{0, 1.5}, heading(90)}, 100, 0, Gear::kForward));
  add(LegKind::kTurn, false,
      arc_from({{100, 1.5}, heading(90)}, 1.5 * std::numbers::pi, 1 / 1.5, Gear::kForward));
  add(LegKind::kWork, true, arc_from({{100, 4.5}, heading(270)}, 100, 0, Gear::kForward));
  add(LegKind::kBackOut, false, arc_from({{0, 4.5}, heading(270)}, 5, 0, Gear::kReverse));
  plan.settings.turns = TurnPlanning::kRoute;
  plan.route.legs[0].piece = 0;
  plan.route.legs[2].piece = 1;
  return plan;
}

}  // namespace tramline::testing_mission
