#include "server/map/headland_sides.h"

#include <gtest/gtest.h>

namespace tramline::server {
namespace {

/// 100 m × 60 m, with a vertex in the middle of its south side, which comes first.
Plan on_rectangle(std::vector<int> edge_passes, int headlands) {
  Plan out;
  out.machine.width_m = 6;
  out.settings.headlands = headlands;
  out.field.outer = {{0, 0}, {40, 0}, {100, 0}, {100, 60}, {0, 60}};
  out.headland.edge_passes = std::move(edge_passes);
  return out;
}

TEST(HeadlandSides, EndAtCornersAndWhereTheNumberOfPassesChanges) {
  const auto sides = headland_sides(on_rectangle({3, 2, 0, 0, 3}, 3));
  ASSERT_EQ(sides.size(), 5U);
  EXPECT_EQ(sides[0], nlohmann::ordered_json(
                          {{"length_m", 100.0}, {"bearing_deg", 270.0}, {"passes", 0}, {"depth_m", 0.0}}));
  EXPECT_EQ(sides[1], nlohmann::ordered_json(
                          {{"length_m", 60.0}, {"bearing_deg", 90.0}, {"passes", 2}, {"depth_m", 12.0}}));
  EXPECT_EQ(sides[2]["bearing_deg"], 0.0) << "the east side";
  EXPECT_EQ(sides[3]["depth_m"], 18.0) << "the west side";
  EXPECT_EQ(sides[4]["length_m"], 40.0);
}

TEST(HeadlandSides, AVertexOnASideIsNoCorner) {
  const auto sides = headland_sides(on_rectangle({}, 2));
  ASSERT_EQ(sides.size(), 4U);
  EXPECT_EQ(sides[0]["length_m"], 100.0);
  EXPECT_EQ(sides[1]["length_m"], 100.0);
  EXPECT_EQ(sides[3]["passes"], 2);
}

TEST(HeadlandSides, ARoundFieldIsOneSide) {
  Plan plan = on_rectangle({}, 1);
  plan.field.outer.clear();
  for (int i = 0; i < 36; ++i)
    plan.field.outer.push_back(80 * Heading::clockwise_from_north(Angle::degrees(-10 * i)).unit());
  const auto sides = headland_sides(plan);
  ASSERT_EQ(sides.size(), 1U);
  // 36 chords of 10° of a circle: 2·80·sin 5° each.
  EXPECT_NEAR(sides[0]["length_m"], 36 * 13.94492, 1e-3);
  EXPECT_TRUE(sides[0]["bearing_deg"].is_null());
}

TEST(HeadlandSides, NoPassesHaveNone) {
  EXPECT_TRUE(headland_sides(on_rectangle({}, 0)).empty());
  EXPECT_TRUE(headland_sides(on_rectangle({0, 0, 0, 0, 0}, 0)).empty());
}

}  // namespace
}  // namespace tramline::server
