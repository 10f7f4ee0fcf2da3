// A plan against its input, and a plan file against itself.

#include <gtest/gtest.h>

#include "check/plans.h"
#include "tramline/check/file/compare_fields.h"
#include "tramline/check/file/compare_layers.h"

namespace tramline {
namespace {

using namespace testing_plans;

TEST(CompareFields, SameField) {
  const Field field = crossing_plan().field;
  EXPECT_TRUE(check::compare_fields(field, field).empty());
}

TEST(CompareFields, ADeletedCornerIsFoundWhereItWas) {
  const Field input = rectangle_plan().field;
  Field planned = input;
  planned.outer.erase(planned.outer.begin() + 2);
  const auto violations = check::compare_fields(planned, input);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].rule, check::Rule::kField);
  EXPECT_NEAR(violations[0].amount, 1500, 1e-3);
}

TEST(CompareFields, ObstaclesAreComparedByKind) {
  const Field input = obstacle_plan().field;
  Field planned = input;
  planned.obstacles.clear();
  EXPECT_EQ(check::compare_fields(planned, input).size(), 1u);
  planned = input;
  planned.obstacles[0].kind = ObstacleKind::kPassable;
  EXPECT_EQ(check::compare_fields(planned, input).size(), 2u);
}

TEST(CompareFields, PlainFramesMayHaveOtherOrigins) {
  Field input = obstacle_plan().field, planned = input;
  planned.frame.origin_x_m = -10;
  for (Point& p : planned.outer) p.x += 10;
  for (Point& p : planned.obstacles[0].shape.outer) p.x += 10;
  EXPECT_TRUE(check::compare_fields(planned, input).empty());
  planned.frame.geodetic = true;
  EXPECT_EQ(check::compare_fields(planned, input).size(), 1u);
}

TEST(CompareLayers, SwathsFollowFromTracks) {
  const Plan plan = obstacle_plan();
  std::vector<int> order;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) order.push_back(static_cast<int>(i) + 1);
  const Region stored = swaths(plan);
  EXPECT_TRUE(check::compare_swaths(plan, order, stored, order).empty());

  Region one_moved = stored;
  for (Point& p : one_moved[3].outer) p.y += 0.001;
  EXPECT_EQ(check::compare_swaths(plan, order, one_moved, order).size(), 1u);

  Region one_missing = stored;
  one_missing.pop_back();
  EXPECT_EQ(check::compare_swaths(plan, order, one_missing, order).size(), 1u);

  std::vector<int> gap = order;
  gap.back() += 1;
  EXPECT_EQ(check::compare_swaths(plan, gap, stored, order).size(), 1u);
}

TEST(CompareLayers, NumbersFollowFromShapes) {
  std::vector<check::Violation> out;
  check::compare_number("layer tracks, feature 1, length_m", 100, 100.00001, 0, {}, out);
  EXPECT_TRUE(out.empty());
  check::compare_number("layer tracks, feature 1, length_m", 100, 100.001, 0, {}, out);
  EXPECT_EQ(out.size(), 1u);
  check::compare_number("layer overlap, feature 1, area_m2", 0.000593, 0.000598, 1e-5, {}, out);
  EXPECT_EQ(out.size(), 1u);
}

}  // namespace
}  // namespace tramline
