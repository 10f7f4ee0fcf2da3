#include "tramline/coverage/plan_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/coverage/deviation.h"

namespace tramline::coverage {
namespace {

Plan plan_with(std::vector<TrackPiece> pieces) {
  Plan plan;
  plan.machine.width_m = 4;
  plan.pieces = std::move(pieces);
  return plan;
}

double gross_m2(const std::vector<WorkedStep>& steps) {
  double sum = 0;
  for (const WorkedStep& step : steps)
    for (const Quad& quad : step.quads) sum += std::abs(signed_area(Ring(quad.begin(), quad.end())));
  return sum;
}

TEST(PlanSteps, APieceIsARunOfItsOwn) {
  const std::vector<WorkedStep> steps = plan_steps(plan_with({{{0, 0}, {10, 0}}, {{10, 4}, {0, 4}}}));
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].quads.at(0), (Quad{{{0, 2}, {0, -2}, {10, -2}, {10, 2}}}));
  EXPECT_EQ(steps[1].quads.at(0), (Quad{{{10, 2}, {10, 6}, {0, 6}, {0, 2}}}));
  EXPECT_EQ(steps[1].run, 1);
  EXPECT_DOUBLE_EQ(steps[1].travel_m, 10);
}

// A quarter circle of radius 6: 3π long, 4 wide.
TEST(PlanSteps, AnArcIsWorkedAsItIs) {
  TrackPiece arc{{0, 0}, {6, 6}};
  arc.curve = {{{0, 0}, {6, 6}, 1.0 / 6}};
  const std::vector<WorkedStep> steps = plan_steps(plan_with({arc}));
  EXPECT_NEAR(gross_m2(steps), 3 * std::numbers::pi * 4, 1e-4);
  EXPECT_NEAR(steps.back().travel_m, 3 * std::numbers::pi, 1e-5);
}

// Half of the way on the track, a quarter 0.5 m beside it, a quarter 3 m beside it and so along none.
TEST(Deviation, IsWeightedByTheWay) {
  const Plan plan = plan_with({{{0, 0}, {100, 0}}});
  const Deviation found = deviation(plan, {{0, {{0, 0}, {25, 0}, {50, 0}}},
                                           {1, {{50, 0.5}, {75, 0.5}}},
                                           {2, {{75, 3}, {100, 3}}},
                                           {-1, {{0, 1}, {100, 1}}}});
  EXPECT_NEAR(found.along_m, 75, 1e-9);
  EXPECT_NEAR(found.beside_m, 25, 1e-9);
  EXPECT_NEAR(found.mean_m, 0.5 * 25 / 75, 1e-9);
  EXPECT_NEAR(found.p95_m, 0.5, 1e-9);
  EXPECT_NEAR(found.most_m, 0.5, 1e-9);
}

}  // namespace
}  // namespace tramline::coverage
