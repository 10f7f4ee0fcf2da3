#include "tramline/geometry/profile/path_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/geometry/path/path_between.h"

namespace tramline::path_profile_test {

constexpr double kPi = std::numbers::pi;

Region box(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}};
}

// A swath 4 m wide north along x = 0 through a triangle whose right side runs from (2, 0) to (−2, 40).
TEST(PathProfile, IsLinearAlongALine) {
  const EdgeIndex index({{{{-30, 0}, {2, 0}, {-2, 40}, {-30, 40}}, {}}});
  const PathProfile profile = path_profile(index, straight_path({0, -10}, {0, 60}), 4);
  const Intervals half = where_at_least(profile, 2), most = where_at_least(profile, 3.999);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(half[0].from, 10, 1e-12);
  EXPECT_NEAR(half[0].to, 30, 1e-9);
  ASSERT_EQ(most.size(), 1u);
  EXPECT_NEAR(most[0].to, 10.01, 1e-9);
  EXPECT_EQ(centre_inside(profile).size(), 1u);
  EXPECT_NEAR(centre_inside(profile)[0].to, 30, 1e-7);
  EXPECT_NEAR(area_between(profile, 0, 70), 80, 1e-9);
  EXPECT_NEAR(area_between(profile, 20, 70), 30 * 30 * 4. / 40 / 2, 1e-9) << "what is left of the wedge";
}

// Half a circle of radius 10 about the origin, from (10, 0) to (−10, 0) through (0, 10), 4 m wide, and the
// half plane y ≥ 9: the cross-section at the angle φ from the x axis is inside from 9 / sin φ on.
TEST(PathProfile, FollowsAnEdgeThroughAnArc) {
  const EdgeIndex index(box(-50, 9, 50, 50));
  for (const bool left : {true, false}) {
    const Path path = left ? Path{{{10, 0}, {0, 10}, 0.1}, {{0, 10}, {-10, 0}, 0.1}}
                           : Path{{{-10, 0}, {0, 10}, -0.1}, {{0, 10}, {10, 0}, -0.1}};
    const PathProfile profile = path_profile(index, path, 4);
    for (const double inside : {0.001, 1.0, 2.0, 2.9}) {
      const double angle = std::asin(9 / (12 - inside));
      const Intervals where = where_at_least(profile, inside);
      ASSERT_EQ(where.size(), 1u);
      EXPECT_NEAR(where[0].from, 10 * angle, 1e-7) << inside;
      EXPECT_NEAR(where[0].to, 10 * (kPi - angle), 1e-7) << inside;
    }
    EXPECT_TRUE(where_at_least(profile, 3.001).empty());
    ASSERT_EQ(centre_inside(profile).size(), 1u);
    EXPECT_NEAR(centre_inside(profile)[0].from, 10 * std::asin(0.9), 1e-7);
    // The segment of the disc of radius 12 beyond y = 9.
    EXPECT_NEAR(area_between(profile, 0, 10 * kPi), 144 * std::acos(0.75) - 9 * std::sqrt(144. - 81), 1e-9);
  }
}

// A band 5 m wide leads obliquely through a swath along an arc of 1000 km, a = atan 0.2 off its start: the
// cross-section after s is inside over 5 / cos(a + s/R), which grows by a micrometre a metre. Both edges
// change by 0.2 m a metre meanwhile, so bounds from edge to edge say next to nothing.
TEST(PathProfile, FindsWhereEdgesThatGoAlongWithOneAnotherAreFarEnoughApart) {
  constexpr double kRadius = 1e6, kApart = 5, kLong = 60, kThere = 25;
  const double off = std::atan(0.2);
  const Point along{std::sin(off), std::cos(off)}, across{std::cos(off), -std::sin(off)};
  const Point from = Point{-8, 0} - 20 * along, to = Point{-8, 0} + 100 * along;
  const EdgeIndex index({{{from, from + kApart * across, to + kApart * across, to}, {}}});
  const double turn = kLong / kRadius;
  const Point end{-kRadius * 2 * std::sin(turn / 2) * std::sin(turn / 2), kRadius * std::sin(turn)};
  const PathProfile profile = path_profile(index, {{{0, 0}, end, 1 / kRadius}}, 24);
  const Intervals where = where_at_least(profile, kApart / std::cos(off + kThere / kRadius));
  ASSERT_EQ(where.size(), 1u);
  EXPECT_NEAR(where[0].from, kThere, 1e-3);
  EXPECT_NEAR(where[0].to, kLong, 1e-6);
}

// A ring's worth of arc inside a box is all inside; a hole takes its area away.
TEST(PathProfile, CountsHoles) {
  Region region = box(-20, -20, 20, 20);
  region[0].holes.push_back({{-0.5, 9.5}, {-0.5, 10.5}, {0.5, 10.5}, {0.5, 9.5}});
  const Path path{{{10, 0}, {0, 10}, 0.1}, {{0, 10}, {-10, 0}, 0.1}};
  const PathProfile profile = path_profile(EdgeIndex(region), path, 4);
  EXPECT_NEAR(area_between(profile, 0, 10 * kPi), 40 * kPi - 1, 1e-9);
  EXPECT_EQ(where_at_least(profile, 3.99).size(), 2u);
  EXPECT_EQ(where_at_least(profile, 1).size(), 1u);
  EXPECT_EQ(centre_inside(profile).size(), 2u);
}

// The side of a swath on the region's edge, and its end: rounding decides neither.
TEST(PathProfile, CountsEdgesThatTouch) {
  const EdgeIndex index(box(0, 0, 12, 40));
  for (const double off : {-1e-12, 0.0, 1e-12}) {
    for (const double x : {2.0, 6.0, 10.0}) {
      const PathProfile up = path_profile(index, straight_path({x + off, 0}, {x + off, 40}), 4);
      const PathProfile down = path_profile(index, straight_path({x + off, 40}, {x + off, 0}), 4);
      EXPECT_NEAR(area_between(up, 0, 40), 160, 1e-8) << x;
      EXPECT_NEAR(area_between(down, 0, 40), 160, 1e-8) << x;
    }
    const PathProfile beside = path_profile(index, straight_path({-2 + off, 0}, {-2 + off, 40}), 4);
    EXPECT_NEAR(area_between(beside, 0, 40), 0, 1e-8);
  }
}

TEST(PathProfile, CutsPathsBetweenPositions) {
  const Path path{{{0, -10}, {0, 0}, 0}, {{0, 0}, {-2, 2}, 0.5}, {{-2, 2}, {-12, 2}, 0}};
  const Path part = path_between(path, 4, 10 + kPi / 2);
  ASSERT_EQ(part.size(), 2u);
  EXPECT_NEAR(length(part), 6 + kPi / 2, 1e-12);
  EXPECT_NEAR(part.back().to.x, -2 + std::sqrt(2.), 1e-12);
  EXPECT_EQ(path_between(path, 0, length(path)), path);
}

}  // namespace tramline::path_profile_test
