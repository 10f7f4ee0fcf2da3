#include "tramline/coverage/tiles/tile_coverage.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/box_ring.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

// Rounding to 7.5 nm over some hundred metres of edges.
constexpr double kTolerance = 1e-6;

using testing_support::box;

Region field() { return {{box(0, 0, 100, 50), {}}}; }

/// A machine that is told where its bar goes.
class Machine {
 public:
  Machine(TileCoverage& engine, double width_m) : engine_(engine), width_m_(width_m) {}

  void begin(Point at, double heading) {
    ++run_;
    travel_m_ = 0;
    at_ = at;
    heading_ = heading;
  }
  void go(Point to, double heading) {
    WorkedStep step;
    const Point left = place(0.5), right = place(-0.5);
    travel_m_ += distance(at_, to);
    at_ = to;
    heading_ = heading;
    step.quads = {{left, right, place(-0.5), place(0.5)}};
    step.run = run_;
    step.travel_m = travel_m_;
    step.reach_m = width_m_;
    engine_.add(step);
  }
  /// Straight, in so many steps, without turning.
  void straight(double length_m, int steps) {
    const Point step = (length_m / steps) * Point{std::cos(heading_), std::sin(heading_)};
    for (int i = 0; i < steps; ++i) go(at_ + step, heading_);
  }
  void turn(double by) { go(at_, heading_ + by); }

 private:
  Point place(double share) const {
    return at_ + share * width_m_ * Point{-std::sin(heading_), std::cos(heading_)};
  }

  TileCoverage& engine_;
  double width_m_;
  Point at_;
  double heading_ = 0;  ///< anticlockwise from east
  int run_ = -1;
  double travel_m_ = 0;
};

constexpr double kEast = 0, kNorth = std::numbers::pi / 2, kWest = std::numbers::pi;

TEST(TileCoverage, BeforeAnythingIsWorkedTheWholeFieldIsMissed) {
  const TileCoverage engine(field(), {});
  EXPECT_NEAR(engine.areas().missed_m2, 5000, kTolerance);
  EXPECT_EQ(engine.areas().covered_m2, 0);
  EXPECT_EQ(engine.stamp(), 0U);
  const Region missed = engine.region(LandClass::kMissed);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_NEAR(area(missed), 5000, kTolerance);
  EXPECT_EQ(missed[0].outer.size(), 4U);
  EXPECT_TRUE(engine.region(LandClass::kCovered).empty());
}

TEST(TileCoverage, OneRectangleInAField) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(30, 7);
  const CoverageAreas& areas = engine.areas();
  EXPECT_NEAR(areas.gross_m2, 120, kTolerance);
  EXPECT_NEAR(areas.covered_m2, 120, kTolerance);
  EXPECT_NEAR(areas.covered_inside_m2, 120, kTolerance);
  EXPECT_NEAR(areas.missed_m2, 4880, kTolerance);
  EXPECT_NEAR(areas.worked_times_m2[1], 120, kTolerance);
  EXPECT_NEAR(areas.worked_times_m2[0], 4880, kTolerance);
  EXPECT_NEAR(areas.worked_twice_m2(), 0, kTolerance);
  EXPECT_NEAR(areas.outside_m2, 0, kTolerance);
  const Region missed = engine.region(LandClass::kMissed);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_EQ(missed[0].holes.size(), 1U);
  EXPECT_NEAR(area(missed), 4880, kTolerance);
}

TEST(TileCoverage, TwoPassesThatCross) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(30, 10);
  machine.begin({20, 5}, kNorth);
  machine.straight(30, 11);
  const CoverageAreas& areas = engine.areas();
  EXPECT_NEAR(areas.covered_m2, 224, kTolerance);
  EXPECT_NEAR(areas.repeated_m2, 16, kTolerance);
  EXPECT_NEAR(areas.sliver_m2, 0, kTolerance);
  EXPECT_NEAR(areas.worked_times_m2[1], 208, kTolerance);
  EXPECT_NEAR(areas.worked_times_m2[2], 16, kTolerance);
  EXPECT_NEAR(area(symmetric_difference(engine.region(LandClass::kRepeated), {{box(18, 18, 22, 22), {}}})), 0,
              1e-4);
}

TEST(TileCoverage, NeighboursThatOverlapAreRepeatedAllAlong) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(30, 60);
  machine.begin({40, 23.8}, kWest);
  machine.straight(30, 41);
  EXPECT_NEAR(engine.areas().repeated_m2, 30 * 0.2, kTolerance);
  EXPECT_NEAR(engine.areas().covered_m2, 30 * 7.8, kTolerance);
}

TEST(TileCoverage, NeighboursThatTouchAreNot) {
  TileCoverage engine({}, {});
  Machine machine(engine, 4);
  const double heading = 0.3;
  machine.begin({1000.1, 2000.2}, heading);
  machine.straight(30, 60);
  machine.begin(Point{1000.1, 2000.2} + 4 * Point{-std::sin(heading), std::cos(heading)}, heading);
  machine.straight(30, 41);
  EXPECT_NEAR(engine.areas().worked_twice_m2(), 0, kTolerance);
  EXPECT_NEAR(engine.areas().covered_m2, 240, kTolerance);
  EXPECT_EQ(engine.region(LandClass::kCovered).size(), 1U);
  EXPECT_TRUE(engine.region(LandClass::kRepeated).empty());
}

// Its own ground again within w of travel is sliver: backwards over 3 of 20 m, 4 m wide. The front of the
// step that works ground again has gone up to 4 m since that of the step that worked it first.
TEST(TileCoverage, ReversingALittleIsSliver) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(20, 20);
  machine.straight(-2, 2);
  EXPECT_NEAR(engine.areas().sliver_m2, 2 * 4, kTolerance);
  EXPECT_NEAR(engine.areas().repeated_m2, 0, kTolerance);
}

// Worked first by the step whose front is at 20 - k, again by that at 20 + k + 1: 2 k + 1 of travel apart.
// k = 0 and 1 are within the reach of 4 m, the other 6 are repeated.
TEST(TileCoverage, ReversingFartherIsRepeated) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(20, 20);
  machine.straight(-8, 8);
  EXPECT_NEAR(engine.areas().sliver_m2, 2 * 4, kTolerance);
  EXPECT_NEAR(engine.areas().repeated_m2, 6 * 4, kTolerance);
}

TEST(TileCoverage, AnotherRunHasNoPartInATrail) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 20}, kEast);
  machine.straight(2, 2);
  machine.begin({10, 20}, kEast);
  machine.straight(2, 2);
  EXPECT_NEAR(engine.areas().repeated_m2, 8, kTolerance);
  EXPECT_NEAR(engine.areas().sliver_m2, 0, kTolerance);
}

// The bar turns about its middle: each step is two triangles with legs of 2 m, half a turn covers a polygon
// of 2 · 18 of them.
TEST(TileCoverage, TurningOnTheSpot) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({50, 25}, kNorth);
  const double by = 10 * std::numbers::pi / 180;
  for (int i = 0; i < 18; ++i) machine.turn(by);
  const double disc = 36 * 0.5 * 2 * 2 * std::sin(by);
  EXPECT_NEAR(engine.areas().covered_m2, disc, kTolerance);
  EXPECT_NEAR(engine.areas().gross_m2, disc, kTolerance);
  EXPECT_NEAR(engine.areas().worked_twice_m2(), 0, kTolerance);
  for (int i = 0; i < 18; ++i) machine.turn(by);
  EXPECT_NEAR(engine.areas().covered_m2, disc, kTolerance);
  EXPECT_NEAR(engine.areas().sliver_m2, disc, kTolerance);
  EXPECT_NEAR(engine.areas().repeated_m2, 0, kTolerance);
}

TEST(TileCoverage, StandingStillIsNothing) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({50, 25}, kNorth);
  for (int i = 0; i < 100; ++i) machine.turn(0);
  EXPECT_EQ(engine.areas().covered_m2, 0);
  EXPECT_EQ(engine.stamp(), 0U);
  EXPECT_TRUE(engine.changes_since(0, LandClass::kCovered).empty());
}

TEST(TileCoverage, AcrossTheBoundary) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({90, 1}, kEast);  // 1 m of the width lies south of the field, 5 m of the way east of it
  machine.straight(15, 10);
  EXPECT_NEAR(engine.areas().covered_inside_m2, 10 * 3, kTolerance);
  EXPECT_NEAR(engine.areas().outside_m2, 60 - 30, kTolerance);
  EXPECT_NEAR(engine.areas().missed_m2, 5000 - 30, kTolerance);
  EXPECT_NEAR(area(engine.region(LandClass::kOutside)), 30, kTolerance);
  EXPECT_NEAR(area(engine.region(LandClass::kMissed)), 4970, kTolerance);
}

TEST(TileCoverage, AHoleOfTheFieldIsOutside) {
  TileCoverage engine({{box(0, 0, 100, 50), {reversed(box(20, 10, 30, 20))}}}, {});
  Machine machine(engine, 4);
  machine.begin({10, 15}, kEast);
  machine.straight(30, 10);
  EXPECT_NEAR(engine.areas().outside_m2, 40, kTolerance);
  EXPECT_NEAR(engine.areas().missed_m2, 4900 - 80, kTolerance);
  EXPECT_NEAR(area(engine.region(LandClass::kMissed)), 4820, kTolerance);
}

// Two passes with a gap, and two across that close it: missed within as a hole of the covered ground.
TEST(TileCoverage, MissedGroundIsAHoleOfTheCovered) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  machine.begin({10, 12}, kEast);
  machine.straight(30, 30);
  machine.begin({10, 22}, kEast);
  machine.straight(30, 30);
  machine.begin({12, 10}, kNorth);
  machine.straight(14, 5);
  machine.begin({38, 10}, kNorth);
  machine.straight(14, 5);
  // A frame 30 × 14 round a hole 22 × 6; the four corners of 4 × 4 are worked twice.
  EXPECT_NEAR(engine.areas().covered_m2, 30 * 14 - 22 * 6, kTolerance);
  EXPECT_NEAR(engine.areas().repeated_m2, 4 * 16, kTolerance);
  const Region covered = engine.region(LandClass::kCovered);
  ASSERT_EQ(covered.size(), 1U);
  ASSERT_EQ(covered[0].holes.size(), 1U);
  EXPECT_NEAR(signed_area(covered[0].holes[0]), -22 * 6, kTolerance);
  const Region missed = engine.region(LandClass::kMissed);
  ASSERT_EQ(missed.size(), 2U);
  EXPECT_NEAR(area(missed), 5000 - 288, kTolerance);
}

TEST(TileCoverage, CountsUpToThree) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  for (int i = 0; i < 5; ++i) {
    machine.begin({10, 20}, kEast);
    machine.straight(10, 5 + i);
  }
  EXPECT_NEAR(engine.areas().worked_times_m2[3], 40, kTolerance);
  EXPECT_NEAR(engine.areas().worked_times_m2[2], 0, kTolerance);
  EXPECT_NEAR(engine.areas().repeated_m2, 40, kTolerance);
  EXPECT_NEAR(engine.areas().gross_m2, 200, kTolerance);
  EXPECT_NEAR(area(engine.region(LandClass::kOften)), 40, kTolerance);
}

TEST(TileCoverage, WhatIsSaturatedStaysAsItIs) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  for (int i = 0; i < 3; ++i) {
    machine.begin({10, 20}, kEast);
    machine.straight(10, 5);
  }
  const std::uint64_t stamp = engine.stamp();
  machine.begin({12, 20}, kEast);
  machine.straight(3, 2);  // all of it worked three times, and repeated
  EXPECT_EQ(engine.stamp(), stamp);
  EXPECT_TRUE(engine.changes_since(stamp, LandClass::kCovered).empty());
  machine.straight(6, 2);  // a metre beyond
  EXPECT_GT(engine.stamp(), stamp);
  const std::vector<TileCoverage::Change> changes = engine.changes_since(stamp, LandClass::kOnce);
  ASSERT_EQ(changes.size(), 1U);  // the tile from 16 to 24 in both directions has all of it
  EXPECT_EQ(changes[0].tile.min_x, 16);
  EXPECT_EQ(changes[0].tile.max_y, 24);
  EXPECT_NEAR(area(changes[0].ground), 4, kTolerance);
}

TEST(TileCoverage, WithoutMultiplicityNothingIsCounted) {
  TileCoverage engine(field(), {8, false});
  EXPECT_TRUE(std::isnan(engine.areas().worked_times_m2[0]));
  EXPECT_TRUE(engine.region(LandClass::kTwice).empty());
}

TEST(TileCoverage, RefusesSenselessTiles) {
  for (const double tile_m : {0.0, -1.0, 1e-3, 1e6, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_REFUSED(TileCoverage({}, {tile_m, true})) << tile_m;
}

// A hundred thousand fixes of a machine that stands, its antenna within 5 cm and its heading within 3
// degrees. The number of cells has to stay bounded: it grows with what is still to come, not with the fixes.
TEST(TileCoverage, StandingWithNoiseStaysSmall) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 4);
  std::mt19937 random(7);
  std::normal_distribution<double> place(0, 0.02), heading(0, 0.02);
  machine.begin({50, 25}, kNorth);
  std::size_t cells_at_a_tenth = 0;
  for (int i = 0; i < 100000; ++i) {
    machine.go({50 + place(random), 25 + place(random)}, kNorth + heading(random));
    if (i == 10000) cells_at_a_tenth = engine.size().cells;
  }
  EXPECT_LT(engine.size().cells, 2 * cells_at_a_tenth);
  EXPECT_LT(engine.areas().covered_m2, 3);
  EXPECT_NEAR(area(engine.region(LandClass::kCovered)), engine.areas().covered_m2, kTolerance);
  for (const Polygon& polygon : engine.region(LandClass::kCovered)) EXPECT_FALSE(find_invalidity(polygon));
}

// Wherever the bar has come out a little further than before there is a new rim, so the number of cells does
// grow; but not as the number of fixes does.
TEST(TileCoverage, TurningWithNoiseForLongStaysSmall) {
  TileCoverage engine(field(), {});
  Machine machine(engine, 24);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.01);
  machine.begin({50, 25}, kNorth);
  std::size_t cells_at_a_fifth = 0;
  for (int i = 0; i < 5000; ++i) {
    machine.go({50 + noise(random), 25 + noise(random)}, 0.01 * i + noise(random));
    if (i == 1000) cells_at_a_fifth = engine.size().cells;
  }
  EXPECT_LT(engine.size().cells, 4 * cells_at_a_fifth);
  EXPECT_NEAR(engine.areas().covered_m2, 144 * std::numbers::pi, 10);
}

}  // namespace
}  // namespace tramline::coverage
