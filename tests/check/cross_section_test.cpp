#include "tramline/check/measure/cross_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "check/plans.h"

namespace tramline {
namespace {

using check::longest_below;

const Polygon kTriangle{{{0, 0}, {100, 0}, {0, 40}}, {}};

TEST(CrossSection, LinearShareAtAnObliqueEdge) {
  // Width 4 about y = 2: all inside up to x = 90, none from x = 100.
  const Path line = straight_path({0, 2}, {120, 2});
  EXPECT_NEAR(longest_below(kTriangle, line, 2, 4).from_m, 90, 1e-9);
  EXPECT_NEAR(longest_below(kTriangle, line, 2, 2).from_m, 95, 1e-9);
  EXPECT_NEAR(longest_below(kTriangle, line, 2, 1).from_m, 97.5, 1e-9);
  EXPECT_NEAR(longest_below(kTriangle, line, 2, 1e-9).from_m, 100, 1e-6);
  EXPECT_NEAR(longest_below(kTriangle, line, 2, 1).to_m, 120, 1e-12);
}

TEST(CrossSection, JumpsWhereAnEdgeLiesAcross) {
  const Polygon step{{{0, 0}, {10, 0}, {10, 2}, {20, 2}, {20, 4}, {0, 4}}, {}};
  const Path line = straight_path({0, 2}, {20, 2});
  const check::Stretch below = longest_below(step, line, 2, 3);
  EXPECT_NEAR(below.from_m, 10, 1e-9);
  EXPECT_NEAR(below.to_m, 20, 1e-9);
  EXPECT_NEAR(below.least_m, 2, 1e-9);
}

TEST(CrossSection, HolesCountAsOutside) {
  const Polygon holed{testing_plans::box(0, 0, 20, 4), {reversed(testing_plans::box(8, 1, 9, 3))}};
  const Path line = straight_path({0, 2}, {20, 2});
  const check::Stretch below = longest_below(holed, line, 2, 4);
  EXPECT_NEAR(below.from_m, 8, 1e-9);
  EXPECT_NEAR(below.length(), 1, 1e-9);
  EXPECT_NEAR(below.least_m, 2, 1e-9);
}

/// An arc of 85 km that ends along an edge of the land, half a width beside it: all but a sliver is inside.
TEST(CrossSection, LandThatEndsAlongTheLeftOfAnArc) {
  constexpr double kRadius_m = 85e3, kLength_m = 800, kHalf_m = 6;
  const double turn = kLength_m / kRadius_m;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place_m(-2000, 2000), angle(-3, 3), off_m(-3e-7, 3e-7);
  for (int i = 0; i < 300; ++i) {
    const Point end{place_m(random), place_m(random)}, heading = turned({1, 0}, angle(random)),
                                                       left = left_of(heading);
    const Point start = end - 2 * kRadius_m * std::sin(turn / 2) * tramline::turned(heading, -turn / 2);
    const Point beside = end + (kHalf_m + off_m(random)) * left;
    const Polygon land{{beside - 900 * heading, beside - 900 * heading - 100 * left,
                        beside + 500 * heading - 100 * left, beside + 500 * heading},
                       {}};
    // It bows out by 800² / (2 · 85,000) = 3.8 m: 8.2 of 12 m are left.
    const Path arc{{start, end, 1 / kRadius_m}};
    EXPECT_EQ(longest_below(land, arc, kHalf_m, 8).length(), 0) << i;
    EXPECT_NEAR(longest_below(land, arc, kHalf_m, 11).to_m, kLength_m - std::sqrt(2 * kRadius_m), 0.1) << i;
  }
}

TEST(CrossSection, ClippedAreasAreRightDownToASquareMicrometre) {
  const Polygon far{{{5000, 5000}, {5000 + 1e-3, 5000}, {5000, 5000 + 1e-3}}, {}};
  const check::PieceFrame frame({5000, 4990}, {5000, 5000});
  EXPECT_NEAR(check::clipped(far, frame, {-1, 10, 1, 11}).area_m2, 0.5e-6, 1e-14);
  EXPECT_NEAR(check::clipped(far, frame, {-1, 10, 1, 10 + 1e-5}).area_m2, 1e-8 - 0.5e-10, 1e-13);
}

/// A comb whose teeth reach into the rectangle: the clipped ring falls into parts.
TEST(CrossSection, ClippingACombAddsUp) {
  const Polygon comb{
      {{0, 10}, {0, 0}, {1, 0}, {1, 8}, {2, 8}, {2, 0}, {3, 0}, {3, 8}, {4, 8}, {4, 0}, {5, 0}, {5, 10}}, {}};
  const check::PieceFrame frame({-5, 2}, {15, 2});
  EXPECT_NEAR(check::clipped(comb, frame, {-1, 0, 1, 20}).area_m2, 3 * 2, 1e-12);
}

}  // namespace
}  // namespace tramline
