// The division of a field on more of its ground than it was made for.

#include "tramline/planner/headland_choice/divided_like.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/box_ring.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::divided_like_test {

using testing_support::box;

Polygon box_shape(double min_x, double min_y, double max_x, double max_y) {
  return {box(min_x, min_y, max_x, max_y), {}};
}

Subfield towards(double clockwise_from_north, Polygon shape) {
  return {std::move(shape), Direction::clockwise_from_north(Angle::degrees(clockwise_from_north))};
}

double common_m2(const Polygon& a, const Polygon& b) { return area(intersection({a}, {b})); }

/// The part with tracks in the direction; the only one.
Polygon part_towards(double clockwise_from_north, const std::vector<Subfield>& parts) {
  std::vector<Polygon> out;
  for (const Subfield& part : parts)
    if (part.direction == Direction::clockwise_from_north(Angle::degrees(clockwise_from_north)))
      out.push_back(part.shape);
  EXPECT_EQ(out.size(), 1U);
  return out.empty() ? Polygon{} : out.front();
}

// One pass of 10 m less all round: the seam at x = 50 m goes on to the edges.
TEST(DividedLike, SeamsGoOnWhereThereAreFewerPasses) {
  const std::vector<Subfield> parts =
      divided_like({box_shape(0, 0, 100, 80)},
                   {towards(0, box_shape(10, 10, 50, 70)), towards(90, box_shape(50, 10, 90, 70))});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(common_m2(part_towards(0, parts), box_shape(0, 0, 50, 80)), 50 * 80, 1e-3);
  EXPECT_NEAR(common_m2(part_towards(90, parts), box_shape(50, 0, 100, 80)), 50 * 80, 1e-3);
}

// The seam runs at 45°, from (20, 20) to (60, 60): straight on it meets the corner of the field, and the
// northern edge at x = 80 m.
TEST(DividedLike, ObliqueSeamsGoOnObliquely) {
  const Polygon west{{{20, 20}, {60, 60}, {20, 60}}, {}};
  const Polygon east{{{20, 20}, {90, 20}, {90, 60}, {60, 60}}, {}};
  const std::vector<Subfield> parts =
      divided_like({box_shape(0, 0, 110, 80)}, {towards(0, west), towards(90, east)});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(area(part_towards(0, parts)), 0.5 * 80 * 80, 1e-2);
  EXPECT_NEAR(area(part_towards(90, parts)), 110 * 80 - 0.5 * 80 * 80, 1e-2);
}

// South and north of a ditch from edge to edge, whose headland gets narrower by 20 m on either side.
TEST(DividedLike, GroundBesideAnObstacleBelongsToTheSubfieldThere) {
  const std::vector<Subfield> parts =
      divided_like({box_shape(0, 0, 100, 90), box_shape(0, 110, 100, 200)},
                   {towards(0, box_shape(0, 0, 100, 70)), towards(1, box_shape(0, 130, 100, 200))});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(common_m2(part_towards(0, parts), box_shape(0, 0, 100, 90)), 100 * 90, 1e-3);
  EXPECT_NEAR(common_m2(part_towards(1, parts), box_shape(0, 110, 100, 200)), 100 * 90, 1e-3);
}

TEST(DividedLike, GroundThatAdjoinsNoSubfieldHasTheLinesOfTheNearest) {
  const std::vector<Subfield> parts =
      divided_like({box_shape(0, 0, 100, 80), box_shape(110, 0, 150, 80)},
                   {towards(0, box_shape(0, 0, 50, 80)), towards(90, box_shape(50, 0, 100, 80))});
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts.back().direction, Direction::clockwise_from_north(Angle::degrees(90)));
  EXPECT_NEAR(area(parts.back().shape), 40 * 80, 1e-3);
}

TEST(DividedLike, GroundOfOneDirectionIsNotDivided) {
  const std::vector<Subfield> parts =
      divided_like({box_shape(0, 0, 100, 80)},
                   {towards(0, box_shape(10, 10, 50, 70)), towards(0, box_shape(50, 10, 90, 70))});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(area(parts.front().shape), 100 * 80, 1e-6);
}

}  // namespace tramline::divided_like_test
