// Headlands with lengths and areas known by hand (Zhou §2.3.3). Where a path turns by τ at a corner, an arc
// of radius R that touches both edges leaves R²·(tan(τ/2) − τ/2) of the corner, a quarter turn R²·(1 − π/4).

#include <gtest/gtest.h>

#include <cmath>

#include "headland/drawn_headlands.h"

namespace tramline::testing::headland_test {

TEST(Headland, OfNoPassesIsNothing) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 60)), {6, 6, 0, {}});
  EXPECT_TRUE(headland.passes.empty());
  EXPECT_TRUE(headland.ground.empty());
  EXPECT_NEAR(area(headland.body), 6000, 1e-6);
  EXPECT_EQ(headland.worked_m2, 0);
}

// The tightest arcs a swath of 6 m allows: its inner edge has a corner.
TEST(Headland, OfARectangle) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 60)), {6, 0, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const HeadlandPass& pass = headland.passes.front();
  EXPECT_TRUE(pass.around_field);
  EXPECT_TRUE(pass.obstacles.empty());
  EXPECT_EQ(pass.number, 1);
  EXPECT_NEAR(length(pass.path), 2 * (94 + 54) - 8 * 3 + 2 * kPi * 3, kLength);
  EXPECT_GT(signed_area(chords(pass.path)), 0) << "the body is on the left";
  EXPECT_NEAR(area(headland.body), 88 * 48, kArea);
  EXPECT_NEAR(area(headland.ground), 6000 - 88 * 48, kArea);
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36, kArea);
  EXPECT_NEAR(headland.overlap_m2, 0, kArea);
}

// Each pass leaves (ρ + w/2)² of the corner outside, and works (ρ − w/2)² inside that belong to the next.
TEST(Headland, LeavesWhatACornerAndAWideTurnAsk) {
  for (const int passes : {1, 2, 3}) {
    const double w = 4, r = 7;
    const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 60)), {w, r, passes, {}});
    ASSERT_EQ(headland.passes.size(), static_cast<std::size_t>(passes));
    EXPECT_EQ(headland.passes.back().number, passes);
    EXPECT_EQ(smallest_radius(headland.passes.back().path), r);
    const double outside = (r + 0.5 * w) * (r + 0.5 * w) + (passes - 1) * 2 * r * w;
    EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * outside, kArea);
    EXPECT_NEAR(headland.overlap_m2, (4 - kPi) * (r - 0.5 * w) * (r - 0.5 * w), kArea);
  }
}

TEST(Headland, OfATriangle) {
  const HeadlandAndBody headland =
      made(field_of({{0, 0}, {100, 0}, {50, 50 * std::sqrt(3.0)}}), {6, 6, 1, {}});
  const double lost = 3 * (std::sqrt(3.0) - kPi / 3);
  EXPECT_NEAR(headland.uncovered_m2, lost * 81, kArea);
  EXPECT_NEAR(headland.overlap_m2, lost * 9, kArea);
}

const Ring kL{{0, 0}, {100, 0}, {100, 50}, {50, 50}, {50, 100}, {0, 100}};

// The machine turns tighter than the pass: an arc about the corner, without loss.
TEST(Headland, GoesRoundAReflexCornerAtItsDistance) {
  const HeadlandAndBody headland = made(field_of(kL), {6, 0, 2, {}});
  ASSERT_EQ(headland.passes.size(), 2u);
  for (const double d : {3.0, 9.0})
    EXPECT_NEAR(length(headland.passes[d < 5 ? 0 : 1].path),
                400 - 5 * 2 * d + 0.5 * kPi * d - 5 * (2 - 0.5 * kPi) * 3, kLength);
  EXPECT_NEAR(area(headland.ground), 400 * 12 - 5 * 144 + kPi * 36, kChords);
  EXPECT_NEAR(headland.uncovered_m2, 5 * (1 - kPi / 4) * (36 + 36), kChords);
  EXPECT_NEAR(headland.overlap_m2, 0, kChords);
}

// It does not: a circle of 6 m that comes to 3 m of the corner in the middle, its centre 3 m behind the
// corner.
TEST(Headland, SwingsWideRoundAReflexCorner) {
  const HeadlandAndBody headland = made(field_of(kL), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const Path& path = headland.passes.front().path;
  EXPECT_NEAR(smallest_radius(path), 6, 1e-6);
  EXPECT_NEAR(distance_to_path({50, 50}, path), 3, 1e-6);
  // The centres of the turns on both sides are 12 m from that of the circle and 9 m from the edges.
  const double behind = 3 / std::sqrt(2.0);
  const double aside = std::sqrt(144 - (9 + behind) * (9 + behind)), turn = std::asin(aside / 12);
  const double straight = 2 * (100 - 9 - 9) + 2 * (50 - 9 - 9) + 2 * (100 - 9 - (50 + behind + aside));
  EXPECT_NEAR(length(path), straight + 5 * 0.5 * kPi * 6 + 2 * 6 * turn + 6 * (0.5 * kPi + 2 * turn),
              kLength);
}

// 2 m between obstacle and edge all around: the second to fifth pass would lie outside.
TEST(Headland, StaysInTheField) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 30, 30), {box(2, 2, 28, 28)}), {1.5, 0, 0, {5}});
  EXPECT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.body.empty());
}

TEST(Headland, MayTakeTheWholeField) {
  const Field field = field_of(box(0, 0, 20, 20));
  const HeadlandAndBody headland = made(field, {6, 0, 2, {}});
  EXPECT_TRUE(headland.body.empty());
  EXPECT_NEAR(area(headland.ground), 400, 1e-6);
  ASSERT_EQ(headland.passes.size(), 1u) << "the second does not fit";
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36 + 8 * 8, kArea);
}

// The obstacle has a second pass; the field has not, and most of a ring would follow the field. It runs along
// the other sides, 9 m off, from where it comes to the field's own pass.
TEST(Headland, DoesNotFollowPassesDrivenAlready) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {box(45, 10, 55, 20)}), {6, 0, 1, {2}});
  ASSERT_EQ(open_ones(headland).size(), 1u);
  const HeadlandPass second = open_ones(headland).front();
  EXPECT_EQ(second.number, 2);
  EXPECT_FALSE(second.around_field);
  EXPECT_EQ(second.obstacles, std::vector<std::size_t>{0});
  const double all = 3 * 10 + 9 * kPi;
  EXPECT_GT(length(second.path), all);
  EXPECT_LT(length(second.path), all + 2 * 5);
  EXPECT_LT(headland.uncovered_m2, 60);
}

TEST(MostPasses, LeaveABody) {
  EXPECT_EQ(most_passes(field_of(box(0, 0, 100, 60)), 6), 4) << "the fifth takes the last 0 m";
  EXPECT_EQ(most_passes(field_of(box(0, 0, 20, 20)), 6), 1);
  EXPECT_EQ(most_passes(field_of(box(0, 0, 10, 10)), 6), 0);
  EXPECT_EQ(most_passes(field_of(box(0, 0, 100, 60), {box(40, 20, 60, 40)}), 6), 4);
}

}  // namespace tramline::testing::headland_test
