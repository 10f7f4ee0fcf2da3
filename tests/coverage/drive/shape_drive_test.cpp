// Ground that logs have as polygons, and figures that are doubted, by hand.

#include "tramline/coverage/drive/shape_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "coverage/logs.h"
#include "support/refusals.h"
#include "tramline/coverage/dose/dose.h"
#include "tramline/coverage/doubts.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

using testing_logs::square;
using testing_support::mentions;

Polygon rectangle_at(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}};
}

WorkLog shapes(std::vector<Polygon> ground, double apart_s) {
  WorkLog out;
  out.name = "applied";
  out.positions = Positions::kLocal;
  out.clock = Clock::kOther;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    Fix fix;
    fix.time_s = apart_s * static_cast<double>(i);
    fix.position = bounds(ground[i].outer).centre();
    fix.record = i + 1;
    fix.shape = static_cast<int>(i);
    out.fixes.push_back(fix);
  }
  out.shapes = std::move(ground);
  return out;
}

/// Ten pieces of 3 by 10 m, side by side eastwards, and a way back 2 m further north.
WorkLog there_and_back() {
  std::vector<Polygon> ground;
  for (int i = 0; i < 10; ++i) ground.push_back(rectangle_at(3 * i, 0, 3, 10));
  for (int i = 9; i >= 0; --i) ground.push_back(rectangle_at(3 * i, 8, 3, 10));
  return shapes(std::move(ground), 1);
}

TEST(ShapeDrive, FiguresOfPolygonsByHand) {
  const Coverage done = evaluate(there_and_back(), square(40), {}, {});
  EXPECT_NEAR(done.areas.gross_m2, 600, 1e-6);
  EXPECT_NEAR(done.areas.covered_m2, 30 * 18, 1e-6);
  EXPECT_NEAR(done.areas.missed_m2, 1600 - 540, 1e-6);
  EXPECT_NEAR(done.areas.worked_times_m2[2], 30 * 2, 1e-6);
  EXPECT_NEAR(done.width_m, 10, 1e-9);
  // The way back follows within a metre and a second: one run of 19 steps of a second.
  EXPECT_EQ(done.runs, 1);
  EXPECT_DOUBLE_EQ(done.worked_s, 19);
  EXPECT_EQ(done.fixes_used, 20U);
}

TEST(ShapeDrive, RunsEndWhereTimeOrPlaceJump) {
  EXPECT_EQ(evaluate(shapes({rectangle_at(0, 0, 3, 10), rectangle_at(3, 0, 3, 10)}, 11), {}, {}, {}).runs, 2);
  EXPECT_EQ(evaluate(shapes({rectangle_at(0, 0, 3, 10), rectangle_at(17, 0, 3, 10)}, 1), {}, {}, {}).runs, 1);
  EXPECT_EQ(evaluate(shapes({rectangle_at(0, 0, 3, 10), rectangle_at(19, 0, 3, 10)}, 1), {}, {}, {}).runs, 2);
}

TEST(ShapeDrive, GroundWithHolesAndGroundThatCrossesItself) {
  Polygon ring = rectangle_at(0, 0, 10, 10);
  ring.holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  EXPECT_NEAR(evaluate(shapes({ring}, 1), {}, {}, {}).areas.covered_m2, 96, 1e-6);
  // Two triangles of 25 m² that touch, with a corner more than a quad has.
  const Polygon crossing = {{{0, 0}, {10, 10}, {10, 5}, {10, 0}, {0, 10}}, {}};
  EXPECT_NEAR(evaluate(shapes({crossing}, 1), {}, {}, {}).areas.covered_m2, 50, 1e-3);
  const Polygon bent = {{{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 2}, {0, 2}}, {}};
  EXPECT_NEAR(evaluate(shapes({bent}, 1), {}, {}, {}).areas.covered_m2, 16 + 12, 1e-6);
}

TEST(ShapeDrive, WhatDidNotWorkWorksNothing) {
  WorkLog log = shapes({rectangle_at(0, 0, 3, 10), rectangle_at(3, 0, 3, 10)}, 1);
  log.fixes[0].work = WorkState::kOn;
  log.fixes[1].work = WorkState::kOff;
  EXPECT_NEAR(evaluate(log, {}, {}, {}).areas.covered_m2, 30, 1e-6);
}

TEST(ShapeDrive, ADoseNeedsADrive) {
  DoseSettings settings;
  settings.rates.nominal_per_ha = 100;
  EXPECT_REFUSED(dose(there_and_back(), {}, settings, {}));
}

CoverageAreas areas(double covered_m2, double repeated_m2) {
  CoverageAreas out;
  out.covered_m2 = covered_m2;
  out.repeated_m2 = repeated_m2;
  out.gross_m2 = covered_m2 + repeated_m2;
  return out;
}

MachineCounters counted(double area_m2) {
  MachineCounters out;
  out.area_m2 = area_m2;
  return out;
}

TEST(Doubts, HalfTheGroundAgain) {
  EXPECT_TRUE(doubts_on(areas(100, 50), {}, 12).empty());
  const auto doubts = doubts_on(areas(100, 51), {}, 12);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_TRUE(mentions(doubts[0], "51 % of the covered land was worked again")) << doubts[0];
  EXPECT_TRUE(mentions(doubts[0], "12 m wide")) << doubts[0];
  EXPECT_TRUE(doubts_on(areas(0, 0), {}, 12).empty());
}

TEST(Doubts, AFifthOffTheCounter) {
  EXPECT_TRUE(doubts_on(areas(80000, 0), counted(100000), 12).empty());
  EXPECT_TRUE(doubts_on(areas(120000, 0), counted(100000), 12).empty());
  EXPECT_TRUE(doubts_on(areas(80000, 0), counted(0), 12).empty());
  for (const double covered_m2 : {79000.0, 121000.0}) {
    const auto doubts = doubts_on(areas(covered_m2, 0), counted(100000), 12);
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_TRUE(mentions(doubts[0], "counter says 10.0000 ha")) << doubts[0];
  }
}

TEST(Doubts, AreToldOfALog) {
  WorkLog log = there_and_back();
  log.counters = counted(1000);
  const Coverage done = evaluate(log, {}, {}, {});
  ASSERT_EQ(done.warnings.size(), 1U);
  EXPECT_TRUE(mentions(done.warnings[0], "0.0540 ha")) << done.warnings[0];
  EXPECT_DOUBLE_EQ(done.counters.area_m2, 1000);
}

}  // namespace
}  // namespace tramline::coverage
