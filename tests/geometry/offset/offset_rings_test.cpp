#include "tramline/geometry/offset/offset_rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/box_ring.h"
#include "tramline/geometry/polygon/smallest_disc.h"

namespace tramline::offset_rings_test {

constexpr double kPi = std::numbers::pi;

using testing_support::box;

double level_area(const std::vector<OffsetBoundary>& offset_boundaries,
                  const std::vector<OffsetDisc>& discs = {}) {
  return area(offset_region(offset_rings(offset_boundaries, discs), 1e-6));
}

TEST(LevelRings, AreSharpInsideCorners) {
  const auto rings = offset_rings({{box(0, 0, 10, 20), 3}});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings.front().size(), 4u);
  EXPECT_NEAR(level_area({{box(0, 0, 10, 20), 3}}), 4 * 14, 1e-9);
}

TEST(LevelRings, AreRoundAboutCornersThatStandOut) {
  const OffsetBoundary outer{box(0, 0, 40, 40), 1}, island{reversed(box(15, 15, 25, 25)), 3};
  EXPECT_EQ(offset_rings({outer, island}).size(), 2u);
  EXPECT_NEAR(level_area({outer, island}), 38 * 38 - 100 - 120 - 9 * kPi, 1e-3);
}

TEST(LevelRings, AreNoneWhereNothingIsFarEnough) {
  EXPECT_TRUE(offset_rings({{box(0, 0, 10, 20), 5.1}}).empty());
  EXPECT_TRUE(offset_rings({{box(0, 0, 10, 20), 5}}).empty()) << "a line is no land";
}

TEST(LevelRings, KeepToTheirSideOfTheShore) {
  // 12 m about an island 3 m from the edge reach beyond it, and so does the disc.
  const OffsetBoundary outer{box(0, 0, 100, 100), 1}, island{reversed(box(40, 3, 50, 8)), 12};
  const auto rings = offset_rings({outer, island}, {{{70, 2}, 6, 0}});
  ASSERT_EQ(rings.size(), 1u);
  for (const OffsetPiece& piece : rings.front()) EXPECT_GE(piece.segment.from.y, 1 - 1e-9);
}

// A disc of 6 m about a place 2 m behind a thin wall reaches 1 m over the line 3 m before it, a segment of
// the circle. Cut along the wall it keeps no land free behind; its two parts keep free what the whole disc
// does.
TEST(LevelRings, KeepOffTheSideOfADiscThatCounts) {
  const std::vector<OffsetBoundary> boundaries{{box(0, 0, 100, 100), 1},
                                               {reversed(box(30, 50, 70, 50.001)), 3}};
  const double without_m2 = level_area(boundaries);
  const double segment_m2 = 36 * std::acos(5.0 / 6) - 5 * std::sqrt(11.0);
  const OffsetDisc whole{{50, 48}, 6, 1};
  OffsetDisc ahead = whole, behind = whole;
  ahead.ahead = {0, 1}, ahead.line_m = 2;
  behind.ahead = {0, -1}, behind.line_m = -2;
  EXPECT_NEAR(without_m2 - level_area(boundaries, {ahead}), segment_m2, 0.02);
  EXPECT_NEAR(level_area(boundaries, {ahead}) + level_area(boundaries, {behind}),
              without_m2 + level_area(boundaries, {whole}), 1e-3);
}

// Edges that run into one another at one distance: an island on the edge, kept off by as much less as it is
// deep.
TEST(LevelRings, TakeLinesThatCoincide) {
  EXPECT_NEAR(level_area({{box(0, 0, 40, 40), 8}, {reversed(box(10, 0, 30, 5)), 3}}), 24 * 24, 1e-6);
}

TEST(LevelRings, GoOnWhereEdgesHardlyTurn) {
  for (const double off : {-1e-6, -1e-8, 0.0, 1e-8, 1e-6}) {
    const Ring ring{{0, 0}, {50, off}, {100, 0}, {100, 100}, {0, 100}};
    EXPECT_NEAR(level_area({{ring, 5}}), 90 * 90, 1e-3) << off;
  }
}

TEST(LevelRings, SayWhomTheyKeepOff) {
  const auto rings = offset_rings({{box(0, 0, 40, 40), 5}, {reversed(box(0, 15, 10, 25)), 5}});
  ASSERT_EQ(rings.size(), 1u);
  int arcs = 0;
  for (const OffsetPiece& piece : rings.front()) {
    if (piece.segment.straight()) continue;
    ++arcs;
    EXPECT_EQ(piece.offset_boundary, 1U);
    EXPECT_LT(piece.segment.curvature, 0);
  }
  EXPECT_EQ(arcs, 2);
}

TEST(SmallestDisc, TouchesTwoOrThree) {
  EXPECT_NEAR(smallest_disc({{0, 0}, {4, 0}, {1, 1}}).radius_m, 2, 1e-12);
  const Disc disc = smallest_disc({{0, 0}, {1, 0}, {0.4, 0.3}, {1, 1}, {0, 1}});
  EXPECT_NEAR(disc.radius_m, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(distance(disc.centre, {0.5, 0.5}), 0, 1e-12);
  EXPECT_EQ(smallest_disc({{3, 4}}).radius_m, 0);
}

}  // namespace tramline::offset_rings_test
