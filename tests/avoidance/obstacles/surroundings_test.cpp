// What is wrong with a swath: by hand, on a field of 40 m × 100 m.

#include "tramline/avoidance/obstacles/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/pole_field.h"

namespace tramline::surroundings_test {

using testing_support::box;

constexpr double kWide = 4;

Surroundings in_field(EdgeKind boundary) {
  Surroundings out;
  out.field = box(0, 0, 40, 100);
  out.boundary = boundary;
  return out;
}

Refusal fault(const Path& path, const Surroundings& around) {
  return fault_of(SwathLine(path, kWide), around);
}

Path upwards(double x) { return straight_path({x, 10}, {x, 90}); }

TEST(Surroundings, OnlyTheCentreLineHasToStayWithinASoftBoundary) {
  EXPECT_EQ(fault(upwards(0.1), in_field(EdgeKind::kSoft)), Refusal::kNone);
  EXPECT_EQ(fault(straight_path({1, 10}, {-1, 90}), in_field(EdgeKind::kSoft)), Refusal::kLeavesField);
  EXPECT_EQ(fault(upwards(-5), in_field(EdgeKind::kSoft)), Refusal::kLeavesField) << "all of it";
}

// 4 m wide: the swath of a line 2 m off the edge touches it.
TEST(Surroundings, TheSwathHasToStayWithinAHardBoundary) {
  EXPECT_EQ(fault(upwards(2), in_field(EdgeKind::kHard)), Refusal::kNone);
  EXPECT_EQ(fault(upwards(1.99), in_field(EdgeKind::kHard)), Refusal::kPassesHardBoundary);
  EXPECT_EQ(fault(upwards(-1), in_field(EdgeKind::kHard)), Refusal::kLeavesField);
}

TEST(Surroundings, TheSwathMayNotEnterPassableLand) {
  Surroundings around = in_field(EdgeKind::kSoft);
  around.passable = {box(20, 45, 24, 55)};
  EXPECT_EQ(fault(upwards(18), around), Refusal::kNone) << "it touches";
  EXPECT_EQ(fault(upwards(18.01), around), Refusal::kEntersPassable);
  EXPECT_EQ(fault(upwards(22), around), Refusal::kEntersPassable);
  EXPECT_EQ(fault(straight_path({22, 10}, {22, 43}), around), Refusal::kNone) << "it ends before";
}

// Half a circle of 10 m from (10, 40) over the peak (20, 50), and points 3 m wide beside it: the swath
// reaches 2 m to either side of the arc, not of its chord.
TEST(Surroundings, ASwathRunsIntoHazardsAlongItsArc) {
  const Path arc{{{10, 40}, {20, 50}, -0.1}, {{20, 50}, {30, 40}, -0.1}};
  const SwathLine line(arc, kWide);
  const auto hazard_at = [](Point p) {
    TurnedHazard out;
    out.outline = box(p.x - 0.1, p.y - 0.1, p.x + 0.1, p.y + 0.1);
    out.box = bounds(out.outline);
    return out;
  };
  const Point centre{20, 40};
  for (const double degrees : {30.0, 45.0, 80.0, 90.0, 135.0}) {
    const Point spoke = turned({1, 0}, degrees * std::numbers::pi / 180);
    for (const double off : {7.5, 12.5})
      EXPECT_FALSE(runs_into(line, hazard_at(centre + off * spoke))) << degrees;
    for (const double off : {8.1, 11.9})
      EXPECT_TRUE(runs_into(line, hazard_at(centre + off * spoke))) << degrees;
  }
  EXPECT_FALSE(runs_into(line, hazard_at(centre)));
}

TEST(Surroundings, ATouchedHazardIsNotRunInto) {
  TurnedHazard post;
  post.outline = box(12, 40, 13, 41);
  post.box = bounds(post.outline);
  const Path before = upwards(10), into = upwards(10.01);
  EXPECT_FALSE(runs_into(SwathLine(before, kWide), post));
  EXPECT_TRUE(runs_into(SwathLine(into, kWide), post));
}

// Tracks run east: x of the frame is −y of the field, y is x.
TEST(Surroundings, LieInThePlaneOfTheTracks) {
  ClassifiedGround ground;
  ground.hazards = {{{box(10, 4, 14, 6), {}}, {0}, Circle{{12, 5}, 2}}};
  ground.passable = {{box(1, 1, 2, 2), {}}};
  const TrackFrame east(Direction::clockwise_from_north(Angle::degrees(90)));
  const Surroundings around = turned_surroundings(ground, box(0, 0, 40, 20), EdgeKind::kHard, east);
  ASSERT_EQ(around.hazards.size(), 1u);
  const TurnedHazard& hazard = around.hazards.front();
  EXPECT_NEAR(hazard.box.min_x, -6, 1e-9);
  EXPECT_NEAR(hazard.box.max_x, -4, 1e-9);
  EXPECT_NEAR(hazard.box.min_y, 10, 1e-9);
  EXPECT_NEAR(hazard.box.max_y, 14, 1e-9);
  EXPECT_NEAR(distance(hazard.round->centre, {-5, 12}), 0, 1e-9);
  EXPECT_EQ(hazard.round->radius, 2);
  ASSERT_EQ(around.passable.size(), 1u);
  EXPECT_NEAR(bounds(around.passable.front()).min_x, -2, 1e-9);
  EXPECT_NEAR(bounds(around.field).min_x, -20, 1e-9);
  EXPECT_NEAR(bounds(around.field).max_y, 40, 1e-9);
  EXPECT_EQ(around.boundary, EdgeKind::kHard);
}

}  // namespace tramline::surroundings_test
