// The verifier's own geometry against GEOS, on random land.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tramline/check/measure/cross_section.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

using check::PieceFrame;

/// A star round the origin, with a hole round it: simple, concave, untidy.
Polygon random_land(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(40, 100), hole_radius(5, 20);
  std::uniform_int_distribution<int> count(5, 40);
  Polygon out;
  const int n = count(random);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    out.outer.push_back(radius(random) * Point{std::cos(t), std::sin(t)});
  }
  Ring hole;
  for (int i = 0; i < 7; ++i) {
    const double t = 2 * std::numbers::pi * i / 7;
    hole.push_back(hole_radius(random) * Point{std::cos(t), std::sin(t)});
  }
  out.holes.push_back(hole);
  return oriented(out);
}

PieceFrame random_piece(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-110, 110);
  const Point start{coordinate(random), coordinate(random)};
  return {start, {coordinate(random), coordinate(random)}};
}

TEST(OtherRoads, ClippedAreasAreThoseOfGeos) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Polygon land = random_land(random);
    const PieceFrame frame = random_piece(random);
    const Box box{-2.5, 0, 2.5, frame.length()};
    const Ring rectangle{frame.to_field({-2.5, 0}), frame.to_field({2.5, 0}),
                         frame.to_field({2.5, frame.length()}), frame.to_field({-2.5, frame.length()})};
    EXPECT_NEAR(check::clipped(land, frame, box).area_m2, area(intersection({land}, {{rectangle, {}}})),
                1e-3);
  }
}

/// Cross-sections measured one by one with GEOS: short of the demand everywhere on the stretch found,
/// and nowhere short over a longer run.
TEST(OtherRoads, StretchesShortOfADemandAreThoseOfSampling) {
  std::mt19937 random(2);
  constexpr double kHalf = 3, kRequired = 2.5, kStep = 0.05;
  for (int i = 0; i < 40; ++i) {
    const Polygon land = random_land(random);
    const PieceFrame frame = random_piece(random);
    const check::Stretch found = check::longest_below(
        land, straight_path(frame.to_field({0, 0}), frame.to_field({0, frame.length()})), kHalf, kRequired);
    double run = 0, longest = 0;
    for (double s = 0.5 * kStep; s < frame.length(); s += kStep) {
      const double inside = length_inside({land}, frame.to_field({-kHalf, s}), frame.to_field({kHalf, s}));
      run = inside < kRequired ? run + kStep : 0;
      longest = std::max(longest, run);
      if (s > found.from_m && s < found.to_m) {
        EXPECT_LT(inside, kRequired + 1e-9);
        EXPECT_GT(inside, found.least_m - 1e-6);
      }
    }
    EXPECT_NEAR(found.length(), longest, 2 * kStep);
  }
}

}  // namespace
}  // namespace tramline
