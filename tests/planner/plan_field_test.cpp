#include "tramline/planner/plan_field.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tramline/geometry/error.h"

namespace tramline::plan_field_test {

Field rectangle(double width, double height) {
  Field field;
  field.id = "rectangle";
  field.outer = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  return field;
}

// 100 × 60 m, w = 3: tracks along the long side, 20 strips of 3 m, none over.
TEST(PlanField, ARectangleIsDrivenAlongItsLongSide) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  const Plan plan = plan_field(rectangle(100, 60), {}, {}, settings);
  EXPECT_EQ(plan.tally.pieces, 20);
  EXPECT_EQ(plan.tally.turns, 19);
  EXPECT_EQ(plan.tally.stops, 0);
  EXPECT_NEAR(plan.tally.track_length_m, 2000, 1e-6);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-3);
  ASSERT_EQ(plan.subfields.size(), 1u);
  EXPECT_NEAR(plan.subfields[0].direction.degrees(), 90, 1e-9);
  EXPECT_EQ(plan.directions_tried, 2);
}

// A pond of 9 × 8 m in strips 7 to 9 (y from 21 to 30), x from 40 to 48: three strips are cut, six
// ends are stops, nothing else is lost because the pond fills its strips.
TEST(PlanField, AnObstacleCutsTheStripsItMeets) {
  Field field = rectangle(100, 60);
  field.obstacles = {{{{{40, 21}, {48, 21}, {48, 30}, {40, 30}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  PlanSettings settings;
  settings.decomposition_threshold = Angle::degrees(300);  // no cuts: corners of the pond are 270
  settings.avoid = Avoidance::kCut;
  const Plan plan = plan_field(field, {}, {}, settings);
  EXPECT_EQ(plan.tally.pieces, 23);
  EXPECT_EQ(plan.tally.stops, 6);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-3);
  EXPECT_NEAR(plan.cost, 1.00 * 22 + 5 * 6, 1e-3);
}

// A hedge rises obliquely through strips 7 and 8 (y from 21 to 27), x from 60 to 120; 2 m behind its upper
// end stands a pole, so that both are one obstacle to the planner. The track of strip 7 goes round the
// hedge's lower end and never comes near the pole.
TEST(PlanField, DetoursNameTheObstaclesBesideThem) {
  Field field = rectangle(200, 60);
  field.obstacles = {
      {{{{60, 21.2}, {120, 26.2}, {120, 26.7}, {60, 21.7}}, {}}, ObstacleKind::kObstacle, "hedge"},
      {{{{122, 26.2}, {122.5, 26.2}, {122.5, 26.7}, {122, 26.7}}, {}}, ObstacleKind::kObstacle, "pole"}};
  PlanSettings settings;
  settings.decomposition_threshold = Angle::degrees(300);
  const Plan plan = plan_field(field, {}, {0.04, 0.10, 0.45, 50}, settings);
  ASSERT_EQ(plan.encounters.size(), 2U);
  for (const Encounter& encounter : plan.encounters)
    EXPECT_EQ(encounter.obstacles,
              encounter.at.y < 24 ? std::vector<std::size_t>{0} : (std::vector<std::size_t>{0, 1}));
  bool before_the_pole = false;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) {
      const double from = std::min(detour.path.front().from.x, detour.path.back().to.x);
      const double to = std::max(detour.path.front().from.x, detour.path.back().to.x);
      if (from > 60 || to > 122) continue;
      before_the_pole = true;
      EXPECT_EQ(detour.obstacles, std::vector<std::size_t>{0});
    }
  EXPECT_TRUE(before_the_pole);
}

TEST(PlanField, AWaterwayInterruptsTheTracksItCrosses) {
  Field field = rectangle(100, 60);
  field.obstacles = {{{{{40, 0}, {45, 0}, {45, 60}, {40, 60}}, {}}, ObstacleKind::kPassable, "waterway"}};
  const Plan plan = plan_field(field, {}, {}, {});
  EXPECT_EQ(plan.tally.pieces, 40);
  EXPECT_EQ(plan.tally.crossings, 20);
  EXPECT_EQ(plan.tally.turns, 19);
  EXPECT_EQ(plan.tally.stops, 0);
  EXPECT_NEAR(area(plan.body), 5700, 1e-6);
  EXPECT_NEAR(plan.tally.worked_m2, 5700, 1e-3);
}

TEST(PlanField, RefusesAMachineWiderThanTheField) {
  Machine wide;
  wide.width_m = 200;
  try {
    plan_field(rectangle(100, 60), wide, {}, {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find("'rectangle'"), std::string::npos);
  }
}

TEST(PlanField, RefusesMoreTracksThanAnyFieldHas) {
  Machine narrow;
  narrow.width_m = 1e-4;
  EXPECT_REFUSED(plan_field(rectangle(100, 60), narrow, {}, {}));
}

TEST(PlanField, RefusesNumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(plan_field(rectangle(100, 60), {"", nan, 6, -1}, {}, {}));
  EXPECT_REFUSED(plan_field(rectangle(100, 60), {"", -3, 6, -1}, {}, {}));
  EXPECT_REFUSED(plan_field(rectangle(100, 60), {"", 3, -6, -1}, {}, {}));
  EXPECT_REFUSED(plan_field(rectangle(100, 60), {}, {nan, 1, 1, 0}, {}));
  PlanSettings settings;
  settings.decomposition_threshold = Angle::degrees(90);
  EXPECT_REFUSED(plan_field(rectangle(100, 60), {}, {}, settings));
}

TEST(PlanField, RefusesLengthsAtObstaclesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double clearance : {nan, inf, -0.1, 1000.1}) {
    PlanSettings settings;
    settings.clearance_m = clearance;
    EXPECT_REFUSED(plan_field(rectangle(100, 60), {}, {}, settings)) << clearance;
  }
  for (const double threshold : {nan, inf, -inf}) {
    PlanSettings settings;
    settings.avoid_threshold_m = threshold;
    EXPECT_REFUSED(plan_field(rectangle(100, 60), {}, {}, settings)) << threshold;
  }
}

TEST(PlanField, HardBoundariesKeepSwathsInside) {
  Field triangle = rectangle(100, 60);
  triangle.outer = {{0, 0}, {100, 0}, {0, 60}};
  PlanSettings settings;
  settings.end_rule = EndRule::kCover;
  settings.boundary = EdgeKind::kHard;
  const Plan plan = plan_field(triangle, {}, {}, settings);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-2);
  for (const std::string& warning : plan.warnings)
    EXPECT_EQ(warning.find("pass the field boundary"), std::string::npos);
  settings.boundary = EdgeKind::kSoft;
  bool warned = false;
  for (const std::string& warning : plan_field(triangle, {}, {}, settings).warnings)
    warned = warned || warning.find("pass the field boundary") != std::string::npos;
  EXPECT_TRUE(warned);
}

// A track 24 m wide, and beside it 60 m along which the field is up to 0.15 mm wider: 45 cm² of land, which
// the layer has as the tally does, since no chord of an arc left it open.
TEST(PlanField, LandBesideStraightTracksIsUncoveredHoweverThin) {
  Field field;
  field.outer = {{0, 0}, {60, 0}, {60, 24.00015}, {0, 24}};
  Machine machine;
  machine.width_m = 24;
  const Plan plan = plan_field(field, machine, {}, {});
  ASSERT_EQ(plan.pieces.size(), 1u);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0.0045, 1e-4);
  EXPECT_NEAR(area(plan.uncovered), plan.tally.uncovered_m2, 1e-4);
}

// Boustrophedon: each piece starts on the side where the one before ended.
TEST(DrivingOrder, GoesUpAndDown) {
  const Plan plan = plan_field(rectangle(100, 60), {}, {}, {});
  for (std::size_t i = 1; i < plan.pieces.size(); ++i)
    EXPECT_NEAR(distance(plan.pieces[i - 1].end, plan.pieces[i].start), 3, 1e-9) << i;
}

}  // namespace tramline::plan_field_test
