#pragma once
// What is true of every whole route, and what is planned to see it.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/box_ring.h"
#include "support/off_the_land.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {

using testing_support::box;

inline Field rectangle(double width_m, double height_m) {
  Field field;
  field.id = "rectangle";
  field.outer = box(0, 0, width_m, height_m);
  return field;
}

inline PlanSettings whole_route(int headlands) {
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.headlands = settings.obstacle_headlands = headlands;
  return settings;
}

inline Pose end_of(const RouteLeg& leg) { return tramline::end_of(leg.path.back()); }

/// Each leg begins in the pose in which the one before it ends, and in one gear.
inline void expect_joined(const Plan& plan) {
  const std::vector<RouteLeg>& legs = plan.route.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    ASSERT_FALSE(legs[i].path.empty()) << "leg " << i;
    for (const SteeredStretch& stretch : legs[i].path) EXPECT_EQ(stretch.gear, legs[i].gear) << "leg " << i;
    if (i == 0) continue;
    const Pose before = end_of(legs[i - 1]), after = legs[i].path.front().start;
    EXPECT_LT(distance(before.at, after.at), 1e-6) << "leg " << i;
    EXPECT_GT(dot(before.heading.unit(), after.heading.unit()), 1 - 1e-9) << "leg " << i;
  }
}

/// Every piece once, in the order of the plan, and every pass once, whole.
inline void expect_all_driven(const Plan& plan) {
  std::size_t next = 0;
  std::vector<double> of_passes(plan.headland.passes.size(), 0);
  for (const RouteLeg& leg : plan.route.legs) {
    if (leg.kind == LegKind::kWork) {
      ASSERT_EQ(leg.piece, next) << "pieces are not in order";
      EXPECT_NEAR(length(leg), length(plan.pieces[next]), 1e-6);
      ++next;
    }
    if (leg.pass) of_passes[*leg.pass] += length(leg);
    EXPECT_EQ(leg.work, leg.kind == LegKind::kWork || leg.kind == LegKind::kHeadland);
  }
  EXPECT_EQ(next, plan.pieces.size());
  for (std::size_t i = 0; i < of_passes.size(); ++i)
    EXPECT_NEAR(of_passes[i], length(plan.headland.passes[i].path), 1e-5) << "pass " << i;
}

/// Beyond a soft boundary without headland the machine may turn.
inline void expect_on_the_land(const Plan& plan) {
  Field land = plan.field;
  if (plan.settings.boundary == EdgeKind::kSoft && plan.settings.headlands == 0) {
    const Box all = bounds(land.outer).grown(1000);
    land.outer = box(all.min_x, all.min_y, all.max_x, all.max_y);
  }
  for (const RouteLeg& leg : plan.route.legs)
    if (!leg.work && leg.missing_m == 0) {
      EXPECT_LT(off_the_land_m(land, plan.machine.width_m, leg.path), 0.005) << name(leg.kind);
    }
}

inline void expect_sound(const Plan& plan) {
  expect_joined(plan);
  expect_all_driven(plan);
  EXPECT_LE(plan.route.proof.bound_s, priced_time_s(plan.route) * (1 + 1e-9));
  EXPECT_GT(plan.route.proof.bound_s, 0);
}

}  // namespace tramline::testing
