#include "tramline/tracks/projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/path/kinked_line.h"

namespace tramline {
namespace {

/// Two legs of √200 m that meet in a right angle at the origin, open upwards.
Path vee() { return polyline_path({{-10, 10}, {0, 0}, {10, 10}}); }

const double kLeg = std::sqrt(200.0);

// (0, 4) lies on the bisector: its feet (∓2, 2) are √8 m from the corner on either leg.
TEST(Projection, OfAPointOnTheBisectorHasTwoFeet) {
  const std::vector<double> feet = Projection(vee()).feet({0, 4});
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_NEAR(feet[0], kLeg - std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(feet[1], kLeg + std::sqrt(8.0), 1e-12);
}

// Off the bisector by a millimetre one leg is nearer; by a micrometre both are as near as the grid can tell.
TEST(Projection, HasOneFootOffTheBisector) {
  const Projection onto(vee());
  const std::vector<double> left = onto.feet({-1e-3, 4}), right = onto.feet({1e-3, 4});
  ASSERT_EQ(left.size(), 1u);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_LT(left[0], kLeg);
  EXPECT_GT(right[0], kLeg);
  EXPECT_EQ(onto.feet({1e-6, 4}).size(), 2u);
}

// Outside the corner the corner itself is nearest, and it is one foot although two segments end there. So is
// a joint on a straight line, and a point a little beside a joint has no second foot there.
TEST(Projection, HasOneFootAtAJoint) {
  const std::vector<double> outside = Projection(vee()).feet({0.5, -3});
  ASSERT_EQ(outside.size(), 1u);
  EXPECT_NEAR(outside[0], kLeg, 1e-12);
  const Projection onto(polyline_path({{0, 0}, {5, 0}, {9, 0}}));
  EXPECT_EQ(onto.feet({5, 2}), std::vector<double>{5});
  const std::vector<double> beside = onto.feet({5.0005, 2});
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_NEAR(beside[0], 5.0005, 1e-12);
}

TEST(Projection, ReachesNoFartherThanTheEnds) {
  const Projection onto(polyline_path({{0, 0}, {5, 0}}));
  EXPECT_EQ(onto.feet({-3, 1}), std::vector<double>{0});
  EXPECT_EQ(onto.feet({7, 1}), std::vector<double>{5});
}

// Three sides of a square of 6 m: its middle is as near to each of them.
TEST(Projection, KeepsMoreThanTwoFeet) {
  const std::vector<double> feet = Projection(polyline_path({{0, 6}, {0, 0}, {6, 0}, {6, 6}})).feet({3, 3});
  EXPECT_EQ(feet, (std::vector<double>{3, 9, 15}));
}

}  // namespace
}  // namespace tramline
