#include "tramline/cost/worked/doubled_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::doubled_ground_test {

constexpr double kWidth = 4;
// Arcs are drawn with chords half a centimetre off at most, over some 20 m of them.
constexpr double kChords_m2 = 0.1;

Plan plan_of(std::vector<TrackPiece> pieces) {
  Plan out;
  out.machine.width_m = kWidth;
  out.pieces = std::move(pieces);
  return out;
}

TrackPiece straight(Point from, Point to, std::size_t subfield) { return {from, to, subfield, 0}; }

TrackPiece curved(const Path& path, std::size_t subfield) {
  TrackPiece out{path.front().from, path.back().to, subfield, 0};
  out.curve = path;
  return out;
}

/// Along y = 0, with half a circle of radius 10 m to the left between two quarters.
TrackPiece round_about() {
  Detour detour;
  detour.path = {{{30, 0}, {40, 10}, 0.1},
                 {{40, 10}, {50, 20}, -0.1},
                 {{50, 20}, {60, 10}, -0.1},
                 {{60, 10}, {70, 0}, 0.1}};
  Path path = {{{0, 0}, {30, 0}}};
  path.insert(path.end(), detour.path.begin(), detour.path.end());
  path.push_back({{70, 0}, {100, 0}});
  TrackPiece out = curved(path, 0);
  out.detours = {detour};
  return out;
}

double doubled_m2(std::vector<TrackPiece> pieces) {
  return area(unite(doubled_ground(plan_of(std::move(pieces)))));
}

TEST(DoubledGround, IsNothingWhereSwathsLieSideBySide) {
  EXPECT_TRUE(doubled_ground(plan_of({})).empty());
  EXPECT_EQ(doubled_m2({straight({0, 2}, {50, 2}, 0), straight({50, 6}, {0, 6}, 0)}), 0);
  EXPECT_EQ(doubled_m2({curved({{{0, 2}, {50, 2}}}, 0), curved({{{50, 6}, {0, 6}}}, 0)}), 0);
  EXPECT_EQ(doubled_m2({round_about()}), 0);
}

TEST(DoubledGround, OfTwoStraightSwathsIsTheSquareWhereTheyCross) {
  EXPECT_NEAR(doubled_m2({straight({0, 0}, {50, 0}, 0), straight({20, -20}, {20, 20}, 1)}), 16, 1e-9);
}

// At its top the detour runs round (50, 10) between the circles of 8 and 12 m. A swath from 18 to 22 m has
// the cap of the larger one that lies more than 8 m above the centre.
TEST(DoubledGround, OfADetourAndItsNeighbourIsTheCap) {
  const double cap_m2 = 144 * std::acos(8.0 / 12) - 8 * std::sqrt(144.0 - 64);
  EXPECT_NEAR(doubled_m2({round_about(), curved({{{0, 20}, {100, 20}}}, 0)}), cap_m2, kChords_m2);
  EXPECT_NEAR(doubled_m2({round_about(), straight({0, 20}, {100, 20}, 1)}), cap_m2, kChords_m2);
}

// Where a straight swath 4 m wide ends a metre within a curved one it has 4 m² of it.
TEST(DoubledGround, OfAStraightAndACurvedSubfield) {
  EXPECT_NEAR(doubled_m2({curved({{{0, 0}, {50, 0}}}, 0), straight({10, 40}, {10, 1}, 1)}), 4, 1e-9);
  EXPECT_NEAR(doubled_m2({straight({10, 40}, {10, 1}, 0), curved({{{0, 0}, {50, 0}}}, 1)}), 4, 1e-9);
}

TEST(DoubledGround, OfTwoSubfieldsAlongDifferentCurves) {
  EXPECT_NEAR(doubled_m2({curved({{{0, 0}, {50, 0}}}, 0), curved({{{20, -20}, {20, 20}}}, 1)}), 16, 1e-9);
  // The swath round the origin from 8 to 12 m has the width of the swath along y = 0 in common, from its
  // arc at 8 m to that at 12 m: as both run across the other's edges, between two arcs less than 2 m high.
  const auto under = [](double r) { return 2 * std::sqrt(r * r - 4) + r * r * std::asin(2 / r); };
  const Path quarters = {{{0, -10}, {10, 0}, 0.1}, {{10, 0}, {0, 10}, 0.1}};
  EXPECT_NEAR(doubled_m2({curved(quarters, 0), curved({{{0, 0}, {50, 0}}}, 1)}), under(12) - under(8),
              kChords_m2);
}

}  // namespace tramline::doubled_ground_test
