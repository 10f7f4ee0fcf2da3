// Lines beside boundaries without passes: where they lie, by hand.
#include "tramline/route/build/lines_beside_boundaries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace tramline {
namespace {

Ring rectangle_of(Box box) {
  return {{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}};
}

Box box_of(const SteeredPath& line) {
  Box out{1e9, 1e9, -1e9, -1e9};
  for (const SteeredStretch& stretch : line)
    for (int part = 0; part <= 20; ++part) {
      const Point p = pose_after(stretch, stretch.length_m * part / 20).at;
      out = {std::min(out.min_x, p.x), std::min(out.min_y, p.y), std::max(out.max_x, p.x),
             std::max(out.max_y, p.y)};
    }
  return out;
}

/// Of arcs points 0.3 m apart are looked at.
constexpr double kSampled_m = 5e-3;

void expect_box(const Box& box, const Box& is) {
  EXPECT_NEAR(box.min_x, is.min_x, kSampled_m);
  EXPECT_NEAR(box.min_y, is.min_y, kSampled_m);
  EXPECT_NEAR(box.max_x, is.max_x, kSampled_m);
  EXPECT_NEAR(box.max_y, is.max_y, kSampled_m);
}

/// A field of 100 by 60 m with a pond of 10 by 10 m in its middle, and a bar 4 m wide.
class BesideBoundaries : public ::testing::Test {
 protected:
  BesideBoundaries() {
    field_.outer = rectangle_of({0, 0, 100, 60});
    Obstacle pond;
    pond.shape = {rectangle_of({45, 25, 55, 35}), {}};
    field_.obstacles.push_back(pond);
    machine_.width_m = 4;
    machine_.radius_m = 5;
  }
  DrivingGround ground() const { return {land_, field_, machine_, {}}; }

  Field field_;
  Machine machine_;
  AllowedLand land_{Region{{rectangle_of({0, 0, 100, 60}), {rectangle_of({45, 25, 55, 35})}}}};
};

/// The bar keeps half its width and a tenth of a metre off: 2.1 m. Round a corner of the pond the machine
/// drives its tightest arc, which comes so near on the diagonal: its centre lies 2.9 m inside the corner.
TEST_F(BesideBoundaries, LieRoundTheFieldAndItsObstacle) {
  const auto lines = lines_beside_boundaries({}, field_, ground());
  ASSERT_EQ(lines.size(), 2U);
  for (const FollowedLine& line : lines) EXPECT_TRUE(line.closed && !line.track);
  const bool round_field_first = box_of(lines.front().axle).min_x < 40;
  expect_box(box_of(lines[round_field_first ? 0 : 1].axle), {2.1, 2.1, 97.9, 57.9});
  const double out_m = 5 - 2.9 / std::numbers::sqrt2;
  expect_box(box_of(lines[round_field_first ? 1 : 0].axle), {45 - out_m, 25 - out_m, 55 + out_m, 35 + out_m});
}

TEST_F(BesideBoundaries, AreNotWherePassesAre) {
  Headland headland;
  headland.obstacle_passes = {1};
  const auto lines = lines_beside_boundaries(headland, field_, ground());
  ASSERT_EQ(lines.size(), 1U);
  expect_box(box_of(lines.front().axle), {2.1, 2.1, 97.9, 57.9});
}

TEST_F(BesideBoundaries, AreFoundOnce) {
  const LinesBesideBoundaries beside;
  const auto* const first = &beside.found({}, field_, ground());
  EXPECT_EQ(first->size(), 2U);
  EXPECT_EQ(&beside.found({}, field_, ground()), first);
}

// With the corners of a pass round the field worked out there is a pass in parts, and none that goes round.
TEST_F(BesideBoundaries, AreThoseOfTheHeadlandWithItsCornersWorkedOutToo) {
  Headland round, in_parts;
  const Path along = {
      {{2, 2}, {98, 2}, 0}, {{98, 2}, {98, 58}, 0}, {{98, 58}, {2, 58}, 0}, {{2, 58}, {2, 2}, 0}};
  round.passes = {{along, 1, true, {}}};
  for (const PathSegment& side : along) in_parts.passes.push_back({{side}, 1, true, {}});
  const LinesBesideBoundaries beside;
  const auto& behind_round = beside.found(round, field_, ground());
  const auto& behind_parts = beside.found(in_parts, field_, ground());
  EXPECT_EQ(behind_round.size(), 1U) << "round the pond";
  EXPECT_EQ(behind_parts.size(), 2U) << "round the field too";
  EXPECT_EQ(&beside.found(round, field_, ground()), &behind_round);
}

/// A bar 2 m wide keeps 1.1 m off. Those of another width are others, and the first ones stay.
TEST_F(BesideBoundaries, AreFoundOnceForEachNarrowerMachine) {
  const LinesForNarrower beside;
  machine_.width_m = 2;
  const DrivingGround narrower = ground();
  const auto* const first = &beside.round_all(field_, narrower);
  ASSERT_EQ(first->size(), 2U);
  const bool round_field_first = box_of(first->front().axle).min_x < 40;
  expect_box(box_of((*first)[round_field_first ? 0 : 1].axle), {1.1, 1.1, 98.9, 58.9});
  machine_.width_m = 1;
  EXPECT_NE(&beside.round_all(field_, ground()), first);
  EXPECT_EQ(&beside.round_all(field_, narrower), first);
}

}  // namespace
}  // namespace tramline
