#include "tramline/render/arrow_places.h"

#include <gtest/gtest.h>

#include "detour_plan.h"

namespace tramline::render {
namespace {

const Box kEverything{-1e6, -1e6, 1e6, 1e6};

TEST(ArrowPlace, IsTheMiddleOfAPlainPiece) {
  const TrackPiece piece{{0, 0}, {30, 40}, 0, 0};
  EXPECT_EQ(arrow_place(piece, 5, kEverything), (Point{15, 20}));
  EXPECT_FALSE(arrow_place(piece, 50, kEverything));
}

TEST(ArrowPlace, KeepsAwayFromDetours) {
  TrackPiece piece{{0, 0}, {120, 0}, 0, 0};
  piece.detours.push_back({sidestep_round(58, 0, 4, 6, 4), Passing::kLeft, {0}});
  const double end = piece.detours[0].path.back().to.x;
  const auto place = arrow_place(piece, 5, kEverything);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, end + 2.5, 1e-9) << "the detour is left nearer to the middle than it begins";
  EXPECT_NEAR(place->y, 0, 1e-9);
}

TEST(ArrowPlace, IsWhereThePieceIsSeen) {
  const TrackPiece piece{{0, 0}, {1000, 0}, 0, 0};
  const auto place = arrow_place(piece, 5, {100, -10, 140, 10});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 120, 1e-9);
  EXPECT_FALSE(arrow_place(piece, 5, {100, 1, 140, 10}));
}

TEST(Clipped, GivesThePartInTheBox) {
  const Box box{0, 0, 10, 10};
  const auto crossing = clipped({-5, 5}, {20, 5}, box);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, (Point{0, 5}));
  EXPECT_EQ(crossing->second, (Point{10, 5}));
  const auto inside = clipped({1, 2}, {3, 4}, box);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->first, (Point{1, 2})) << "ends that are inside stay as they are";
  EXPECT_EQ(inside->second, (Point{3, 4}));
  EXPECT_FALSE(clipped({-5, 5}, {5, 20}, box)) << "past the corner";
  EXPECT_FALSE(clipped({11, -5}, {11, 20}, box)) << "along a side";
}

}  // namespace
}  // namespace tramline::render
