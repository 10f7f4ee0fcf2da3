// Headlands in necks, arms and strips, with lengths and areas known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "headland/drawn_headlands.h"
#include "support/turned_ring.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing::narrow_land_test {

/// Of a circle, beyond a chord.
double cap_m2(double radius, double height) {
  const double off = radius - height;
  return radius * radius * std::acos(off / radius) - off * std::sqrt(radius * radius - off * off);
}

// Two swaths of 6 m fit into 12 m. In a little less they share what is missing, along the obstacle and, where
// the swath goes round its corners with a radius of 6 m, beyond it.
TEST(Headland, PassesANarrowGapOnBothSides) {
  const auto with_gap = [](double gap) { return field_of(box(0, 0, 100, 100), {box(45, gap, 55, 20)}); };
  const HeadlandAndBody tight = made(with_gap(11.9), {6, 0, 1, {1}});
  EXPECT_EQ(tight.passes.size(), 2u);
  EXPECT_NEAR(tight.overlap_m2, 10 * 0.1 + cap_m2(6, 0.1), kChords);
  const HeadlandAndBody fitting = made(with_gap(12), {6, 0, 1, {1}});
  EXPECT_EQ(fitting.passes.size(), 2u);
  EXPECT_NEAR(fitting.overlap_m2, 0, kChords);
  EXPECT_EQ(made(with_gap(5.9), {6, 0, 1, {1}}).passes.size(), 1u) << "not even one swath fits";
}

/// Rooms of 40 m and a corridor between them, 20 m long.
Ring rooms(double corridor) {
  const double low = 20 - 0.5 * corridor, high = 20 + 0.5 * corridor;
  return {{0, 0},    {40, 0},  {40, low},  {60, low},  {60, 0},  {100, 0},
          {100, 40}, {60, 40}, {60, high}, {40, high}, {40, 40}, {0, 40}};
}

// 8 m: the machine could not turn there. The swaths share 4 m of the corridor, and before it what is within 6
// m of a corner on either side.
TEST(Headland, GoesThroughANeck) {
  const HeadlandAndBody headland = made(field_of(rooms(8)), {6, 0, 1, {}});
  EXPECT_EQ(headland.body.size(), 2u);
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_NEAR(length(headland.passes.front().path), 2 * (3 * 28 + 2 * 10) + 2 * 20 + 12 * 1.5 * kPi, kLength);
  EXPECT_NEAR(headland.overlap_m2, 4 * 20 + 2 * cap_m2(6, 2), kChords);
}

// 14 m, but the machine turns with 6 m: 9 + 9 m would do. Both sides of the corridor are driven and the 2 m
// between them are left.
TEST(Headland, GoesThroughANeckWithWideTurns) {
  const HeadlandAndBody headland = made(field_of(rooms(14)), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const Path& path = headland.passes.front().path;
  EXPECT_NEAR(distance_to_path({50, 16}, path), 0, 1e-6);
  EXPECT_NEAR(distance_to_path({50, 24}, path), 0, 1e-6);
  EXPECT_NEAR(smallest_radius(path), 6, 1e-6);
}

TEST(Headland, ComesApartWhereNoSwathFits) {
  const HeadlandAndBody headland = made(field_of(rooms(5.9)), {6, 0, 1, {}});
  EXPECT_EQ(headland.passes.size(), 2u);
  EXPECT_GT(headland.uncovered_m2, 20 * 5.9);
}

// 23.9 m between an obstacle of 4 m and the boundary, 24 m to turn in: turns from both sides, about centres
// √(12² − 11.9²) m beside the obstacle, would cross. The boundary bends by 4e-7 rad, by which lines at 6 m
// and at 12 m do not end abreast. Each is driven round by itself.
TEST(Headland, GoesThroughANeckBesideABoundaryThatHardlyBends) {
  const Ring outer{{0, 0}, {100, 2e-5}, {200, 0}, {200, 100}, {0, 100}};
  const HeadlandAndBody headland = made(field_of(outer, {box(60, 23.9, 64, 30)}), {12, 6, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 2u);
  const double corners = 2 * kPi * 6;
  EXPECT_NEAR(length(headland.passes[0].path), 2 * (200 - 24 + 100 - 24) + corners, 1e-3);
  EXPECT_NEAR(length(headland.passes[1].path), 2 * (4 + 6.1) + corners, 1e-3);
}

// An arm of 23 m: two passes lie beside one another there, between which the machine cannot turn. However the
// land is turned and wherever its outline begins, they are found.
TEST(Headland, WorksAnArmWhereverTheOutlineBegins) {
  const Ring outline{{0, 0}, {60, 3}, {62, 47}, {160, 45}, {160, 68}, {-2, 70}};
  const HeadlandAndBody first = made(field_of(outline), {12, 6, 1, {}});
  EXPECT_LT(first.uncovered_m2, 400) << "the arm has 2300 m²";
  for (std::size_t begin = 0; begin < outline.size(); ++begin)
    for (int i = 0; i < 12; ++i) {
      Ring ring = testing_support::turned(outline, 0.5 * i);
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin), ring.end());
      const HeadlandAndBody same = made(field_of(std::move(ring)), {12, 6, 1, {}});
      EXPECT_NEAR(same.uncovered_m2, first.uncovered_m2, 1) << begin << ' ' << i;
    }
}

// A wedge of 500 m by 90 m is 24 m wide 133 m from its tip, where the machine turns round: 1600 m² lie
// beyond. A swath of 12 m fits up to 67 m from the tip, beyond which 400 m² are left; the rest are the
// corners.
TEST(Headland, DrivesIntoTheTipOfAWedge) {
  const HeadlandAndBody headland = made(field_of({{0, 0}, {500, 45}, {0, 90}}), {12, 6, 1, {}});
  EXPECT_GT(headland.passes.size(), 1U);
  EXPECT_LT(headland.uncovered_m2, 400 + 400);
}

/// With a point every few metres of each edge, bowed outwards by so much in its middle.
Ring with_points_on_edges(const Ring& ring, double bow_m) {
  constexpr int kParts = 8;
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    const Point outwards = (1 / distance(from, to)) * right_of(to - from);
    for (int k = 0; k < kParts; ++k) {
      const double at = static_cast<double>(k) / kParts;
      out.push_back(from + at * (to - from) + 4 * at * (1 - at) * bow_m * outwards);
    }
  }
  return out;
}

// An outline as a receiver records it has points all along its edges, which are next to straight there.
TEST(Headland, WorksAnArmWhateverPointsItsEdgesHave) {
  const Ring arm{{0, 0}, {60, 3}, {62, 47}, {160, 45}, {160, 68}, {-2, 70}};
  const Ring strip{{0, 0}, {26, 0}, {26, 130}, {0, 132}};
  for (const Ring& outline : {arm, strip}) {
    const HeadlandAndBody first = made(field_of(outline), {12, 8, 1, {}});
    for (const double bow_m : {0.0, 1e-6, 1e-5, 1e-4, -1e-6, -1e-5, -1e-4})
      for (int i = 0; i < 12; ++i) {
        const Ring ring = testing_support::turned(with_points_on_edges(outline, bow_m), 0.5 * i);
        const HeadlandAndBody same = made(field_of(ring), {12, 8, 1, {}});
        EXPECT_EQ(same.passes.size(), first.passes.size()) << bow_m << ' ' << i;
        EXPECT_NEAR(same.uncovered_m2, first.uncovered_m2, 5) << bow_m << ' ' << i;
      }
  }
}

/// A strip 120 m long whose last part bends off, so long beyond the bend.
Ring bent_strip(double wide, double beyond, double turned_rad) {
  const Point along{-std::cos(turned_rad), std::sin(turned_rad)};
  const Point inside{wide * std::tan(0.5 * turned_rad), wide};
  return {{0, 0}, {120, 0}, {120, wide}, inside, inside + beyond * along, beyond * along};
}

// Close to the end of a strip in which it cannot turn the machine goes round the bend, where straight on it
// would leave the land beyond: 7 to 12 % of these.
TEST(Headland, GoesRoundABendCloseToTheEndOfAStrip) {
  for (const double wide : {21.0, 23.0}) {
    const Ring ring = bent_strip(wide, 24, 0.6);
    const HeadlandAndBody headland = made(field_of(ring), {12, 6, 1, {}});
    EXPECT_LT(headland.uncovered_m2, 0.05 * std::abs(signed_area(ring))) << wide;
  }
}

// The corridor bends twice: outside the machine rounds the corner, inside it swings wide.
TEST(Headland, GoesRoundCornersInANeck) {
  const Ring rooms{{0, 0},    {40, 0},  {40, 13}, {77, 13}, {77, 60}, {120, 60}, {120, 100},
                   {60, 100}, {60, 74}, {63, 74}, {63, 27}, {40, 27}, {40, 40},  {0, 40}};
  const HeadlandAndBody headland = made(field_of(rooms), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_NEAR(distance_to_path({50, 16}, headland.passes.front().path), 0, 1e-6);
  EXPECT_NEAR(distance_to_path({50, 24}, headland.passes.front().path), 0, 1e-6);
  EXPECT_NEAR(distance_to_path({74, 45}, headland.passes.front().path), 0, 1e-6);
  EXPECT_NEAR(distance_to_path({66, 45}, headland.passes.front().path), 0, 1e-6);
}

// Three corridors of 10 m meet where there is no room to turn either.
TEST(Headland, GoesThroughNecksThatMeet) {
  const Ring star{{0, 0},   {40, 0},  {40, 15}, {80, 15}, {80, 0},  {120, 0},  {120, 40},
                  {80, 40}, {80, 25}, {65, 25}, {65, 60}, {90, 60}, {90, 100}, {30, 100},
                  {30, 60}, {55, 60}, {55, 25}, {40, 25}, {40, 40}, {0, 40}};
  const HeadlandAndBody headland = made(field_of(star), {4, 3.5, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  for (const Point p : {Point{60, 17}, Point{57, 45}, Point{63, 45}})
    EXPECT_NEAR(distance_to_path(p, headland.passes.front().path), 0, 1e-6);
}

// 19.8 m wide: one pass has room for its turns of 6 m, the second has 1.8 m. What is 6 m and more from the
// edge is left to tracks, as far as the first pass leaves it: 7.8 m across, and from turn to turn at least
// the 100 − 2·9 − 2·6 m without their bands. Radius 6.9 + 3 m about a centre 9.9 m from the ends.
TEST(Headland, LeavesTheMiddleOfAStripToTracks) {
  const Field field = field_of(box(0, 0, 100, 19.8));
  const HeadlandAndBody headland = made(field, {6, 6, 2, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  ASSERT_EQ(headland.body.size(), 1u);
  const Box reach = bounds(headland.body.front().outer);
  EXPECT_NEAR(reach.height(), 7.8, 1e-3);
  EXPECT_NEAR(reach.width(), 88, 1e-3);
  // The first pass works 6 m all round but for what its turns leave outside, and 3 m inside, of corners.
  const double corner = 1 - kPi / 4;
  EXPECT_NEAR(area(headland.body), 88 * 7.8 - 4 * corner * 9, 0.2);
  EXPECT_NEAR(headland.uncovered_m2, 4 * corner * 81, 0.2);
  // Too short for a track of 100 m, and just long enough.
  EXPECT_TRUE(made(field, {6, 6, 2, {}, 100}).body.empty());
  EXPECT_FALSE(made(field, {6, 6, 2, {}, 87}).body.empty());
}

// Between the two sides of the pass a strip of 2.1 m, more than a third of a swath, is left to tracks; one of
// 1.9 m is not.
TEST(Headland, LeavesNarrowStripsToTracks) {
  const HeadlandAndBody wide = made(field_of(box(0, 0, 100, 14.1)), {6, 3, 2, {}});
  ASSERT_EQ(wide.passes.size(), 1u);
  ASSERT_EQ(wide.body.size(), 1u);
  EXPECT_NEAR(bounds(wide.body.front().outer).height(), 2.1, 1e-3);
  const HeadlandAndBody narrow = made(field_of(box(0, 0, 100, 13.9)), {6, 3, 2, {}});
  ASSERT_EQ(narrow.passes.size(), 1u);
  EXPECT_TRUE(narrow.body.empty());
  EXPECT_GT(narrow.uncovered_m2, 1.9 * 85);
}

// A dead end of 14 m, 9 + 9 m to turn in: a pass along either side, as far as the wall at its end.
TEST(Headland, DrivesIntoADeadEndWhereItCannotTurn) {
  const Ring with_arm{{0, 0}, {40, 0}, {40, 13}, {80, 13}, {80, 27}, {40, 27}, {40, 40}, {0, 40}};
  const HeadlandAndBody headland = made(field_of(with_arm), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 3u);
  const std::vector<HeadlandPass> open = open_ones(headland);
  ASSERT_EQ(open.size(), 2u);
  for (const HeadlandPass& pass : open) {
    EXPECT_TRUE(pass.around_field);
    EXPECT_EQ(pass.number, 1);
    EXPECT_NEAR(reach_of(pass.path, 0).max_x, 80, 1e-3);
    EXPECT_GT(length(pass.path), 33);
  }
  // Each has the wall it follows on its right: out of the arm, and into it.
  EXPECT_NEAR(open[0].path.front().from.y, 24, 1e-6);
  EXPECT_NEAR(open[1].path.back().to.y, 16, 1e-6);
  // The corners of the room, and what the wide turns into the arm leave about its mouth. The middle of the
  // arm, 2 m wide, is body.
  EXPECT_LT(headland.uncovered_m2, 4 * (1 - kPi / 4) * 81 + 45);
}

/// A block of 120 m and an arm along its west side, 17 m wide and 440 m long.
const Ring kWithArm{{0, 0}, {120, 0}, {120, 120}, {17, 120}, {17, 560}, {0, 560}};

// 17 m, and 24 m to turn in. The arm is worked all across, its middle twice, however many passes are asked
// for.
TEST(Headland, WorksAnArmTooNarrowToTurnIn) {
  for (const int passes : {1, 2, 3}) {
    const HeadlandAndBody headland = made(field_of(kWithArm), {12, 6, passes, {}});
    EXPECT_EQ(open_ones(headland).size(), 2u) << passes;
    const Region left = intersection(unworked_ground(headland, 12), {{box(0, 135, 17, 560), {}}});
    EXPECT_LT(area(left), 1) << passes;
  }
}

// Both sides of a narrow passage are driven, by the ring round the field; in one of 6.5 m the second one
// works 0.5 m.
TEST(Headland, DrivesThroughNecksAtLeastOnce) {
  const auto with_passage = [](double width) {
    const double low = 60 - 0.5 * width, high = 60 + 0.5 * width;
    return field_of({{0, 0},
                     {120, 0},
                     {120, low},
                     {200, low},
                     {200, 0},
                     {320, 0},
                     {320, 120},
                     {200, 120},
                     {200, high},
                     {120, high},
                     {120, 120},
                     {0, 120}});
  };
  for (const double width : {8.0, 9.0, 10.0})
    for (const int passes : {1, 2}) {
      const HeadlandAndBody headland = made(with_passage(width), {6, 6, passes, {}});
      const Region left = intersection(unworked_ground(headland, 6), {{box(125, 0, 195, 120), {}}});
      EXPECT_LT(area(left), 1) << width;
    }
  const HeadlandAndBody narrow = made(with_passage(6.5), {6, 6, 1, {}});
  const Region left = intersection(unworked_ground(narrow, 6), {{box(125, 0, 195, 120), {}}});
  EXPECT_NEAR(area(left), 70 * 0.5, 1);
}

// Narrow parcels: one drive, or one along either side. The second one works what is wider than 6 m.
TEST(Headland, WorksNarrowParcelsByPassesAlone) {
  const auto strip = [](double width, int passes) {
    return made(field_of(box(0, 0, 200, width)), {6, 6, passes, {}});
  };
  EXPECT_TRUE(strip(5.9, 1).passes.empty());
  EXPECT_EQ(strip(6, 1).passes.size(), 1u);
  EXPECT_NEAR(length(strip(6.5, 2).passes.front().path), 200, 0.01);
  for (const double width : {7.5, 10.0})
    for (const int passes : {1, 2}) {
      const HeadlandAndBody headland = strip(width, passes);
      EXPECT_EQ(headland.passes.size(), 2u) << width;
      EXPECT_TRUE(headland.body.empty()) << width;
      EXPECT_NEAR(headland.uncovered_m2, 0, 0.1) << width;
      EXPECT_NEAR(headland.overlap_m2, 200 * (12 - width), 0.5) << width;
    }
}

TEST(Headland, FitsWhereItJustFits) {
  const HeadlandAndBody square = made(field_of(box(0, 0, 24, 24)), {6, 0, 2, {}});
  ASSERT_EQ(square.passes.size(), 2u);
  EXPECT_NEAR(length(square.passes.back().path), 6 * kPi, kLength);
  const HeadlandAndBody strip = made(field_of(box(0, 0, 60, 12)), {6, 0, 1, {}});
  ASSERT_EQ(strip.passes.size(), 1u);
  EXPECT_NEAR(length(strip.passes.front().path), 2 * 48 + 6 * kPi, kLength);
}

}  // namespace tramline::testing::narrow_land_test
