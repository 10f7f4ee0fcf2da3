// How near land comes to a swath, against figures known by hand and against GEOS.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "check/plans.h"
#include "tramline/check/measure/swath_clearance.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using namespace testing_plans;
using check::PieceFrame;
using check::SwathClearance;

const PieceFrame kEast({0, 0}, {100, 0});

double gap(const SwathClearance& swath, const Ring& land, double reach_m = 10) {
  return swath.to_land({land, {}}, reach_m).gap_m;
}

TEST(SwathClearance, Straight) {
  const SwathClearance swath(kEast, straight_path({20, 0}, {40, 0}), 1.5);
  EXPECT_NEAR(gap(swath, box(25, 2, 30, 3)), 0.5, 1e-12);
  EXPECT_NEAR(gap(swath, box(25, 1, 30, 3)), -0.5, 1e-12);
  EXPECT_NEAR(gap(swath, box(25, -0.1, 25.1, 0.1)), -1.5, 1e-12);
  // Beyond the flat ends, straight ahead and past the corner.
  EXPECT_NEAR(gap(swath, box(40.7, -1, 50, 1)), 0.7, 1e-12);
  EXPECT_NEAR(gap(swath, box(40.3, 1.9, 50, 3)), 0.5, 1e-12);
  EXPECT_GT(gap(swath, box(40.1, -1, 50, 1), 0), 0);
  // All round, and in the middle of a ring of land.
  EXPECT_LE(gap(swath, box(-50, -50, 150, 50)), -1.5);
  EXPECT_NEAR(swath.to_land({box(-50, -50, 150, 50), {box(10, -5, 90, 5)}}, 10).gap_m, 3.5, 1e-12);
  EXPECT_GT(gap(swath, box(25, 50, 30, 60)), 10);
}

/// Random poles beside a bulge: the band's own distance by GEOS, less what its chords take.
TEST(SwathClearance, GapsAreTheDistancesOfTheBand) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(35, 65), y(-4, 8), size(0.01, 1), turn(0, 6.3);
  const TrackPiece piece{{0, 0}, {100, 0}, 0, 0};
  const Path path = bulge(piece, 50, 2.5, 6, Passing::kLeft, {}).path;
  const SwathClearance swath(kEast, path, 1.5);
  const Region ground{{band(path, 3, 1e-7), {}}};
  int apart = 0, within = 0;
  for (int i = 0; i < 500; ++i) {
    const Point at{x(random), y(random)};
    const double s = size(random), t = turn(random);
    Ring land;
    for (int k = 0; k < 3; ++k) land.push_back(at + s * Point{std::cos(t + 2.1 * k), std::sin(t + 2.1 * k)});
    const double expected = distance_between(ground, {{land, {}}});
    const double found = gap(swath, land);
    if (expected > 1e-5) {
      EXPECT_NEAR(found, expected, 1e-5);
      ++apart;
    } else if (area(intersection(ground, {{land, {}}})) > 0.01) {
      EXPECT_LT(found, 0);
      ++within;
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(within, 50);
}

TEST(SwathClearance, PlacesOutsideARing) {
  const Ring field = box(0, -2, 100, 2);
  EXPECT_FALSE(SwathClearance(kEast, straight_path({0, 0}, {100, 0}), 1).point_outside(field));
  EXPECT_FALSE(SwathClearance(kEast, straight_path({0, 2}, {100, 2}), 1).point_outside(field));
  EXPECT_FALSE(SwathClearance(kEast, straight_path({0, 2.0009}, {100, 2.0009}), 1).point_outside(field));
  EXPECT_TRUE(SwathClearance(kEast, straight_path({0, 2.002}, {100, 2.002}), 1).point_outside(field));
  EXPECT_TRUE(SwathClearance(kEast, straight_path({-1, 0}, {100, 0}), 1).point_outside(field));
  EXPECT_FALSE(SwathClearance(kEast, straight_path({-1, 0}, {100, 0}), 1).point_pushed_outside(field));
  EXPECT_TRUE(SwathClearance(kEast, straight_path({0, 50}, {100, 50}), 1).point_outside(field));
  EXPECT_TRUE(SwathClearance(kEast, straight_path({0, 50}, {100, 50}), 1).point_pushed_outside(field));
}

}  // namespace
}  // namespace tramline
