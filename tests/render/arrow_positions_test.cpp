#include "tramline/render/page/arrow_positions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "detour_plan.h"

namespace tramline::render {
namespace {

const Box kEverything{-1e6, -1e6, 1e6, 1e6};

TEST(ArrowPlace, IsTheMiddleOfAPlainPiece) {
  const TrackPiece piece{{0, 0}, {30, 40}, 0, 0};
  const auto place = arrow_position(piece, 5, kEverything);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->at, (Point{15, 20}));
  EXPECT_NEAR(distance(place->along, {0.6, 0.8}), 0, 1e-12);
  EXPECT_FALSE(arrow_position(piece, 50, kEverything));
}

TEST(ArrowPlace, KeepsAwayFromDetours) {
  TrackPiece piece{{0, 0}, {120, 0}, 0, 0};
  piece.detours.push_back({sidestep_round(58, 0, 4, 6, 4), Passing::kLeft, {0}});
  const double end = piece.detours[0].path.back().to.x;
  const auto place = arrow_position(piece, 5, kEverything);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->at.x, end + 2.5, 1e-9) << "the detour is left nearer to the middle than it begins";
  EXPECT_NEAR(place->at.y, 0, 1e-9);
}

TEST(ArrowPlace, IsWhereThePieceIsSeen) {
  const TrackPiece piece{{0, 0}, {1000, 0}, 0, 0};
  const auto place = arrow_position(piece, 5, {100, -10, 140, 10});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->at.x, 120, 1e-9);
  EXPECT_FALSE(arrow_position(piece, 5, {100, 1, 140, 10}));
}

TEST(ArrowPlace, IsOnTheCurveAndPointsAlongIt) {
  // A quarter circle to the left from (0, 0), heading east, to (100, 100).
  TrackPiece piece{{0, 0}, {100, 100}, 0, 0};
  piece.curve = {{{0, 0}, {100, 100}, 0.01}};
  const auto place = arrow_position(piece, 5, kEverything);
  ASSERT_TRUE(place);
  const double half = 50 * std::sqrt(2.0);
  EXPECT_NEAR(distance(place->at, {half, 100 - half}), 0, 0.01);
  EXPECT_NEAR(distance(place->along, {std::sqrt(0.5), std::sqrt(0.5)}), 0, 0.01);
  EXPECT_FALSE(arrow_position(piece, 160, kEverything)) << "157 m are too short for that";
}

TEST(ArrowPlace, IsInTheLongestStretchOfACurveThatIsSeen) {
  TrackPiece piece{{0, 0}, {200, 0}, 0, 0};
  piece.curve = {{{0, 0}, {200, 0}, 0.01}};  // half a circle through (100, −100)
  const auto place = arrow_position(piece, 5, {-10, -40, 210, 10});
  ASSERT_TRUE(place);
  EXPECT_NEAR(distance(place->at, {100, 0}), 100, 0.01);
  EXPECT_LT(place->at.y, -15);
  EXPECT_GT(place->at.y, -25);
  EXPECT_FALSE(arrow_position(piece, 5, {90, -10, 110, 10})) << "inside the bend";
}

TEST(ArrowPlacesRound, AreEvenlySpaced) {
  const Path round{
      {{0, 0}, {100, 0}, 0}, {{100, 0}, {100, 20}, 0.1}, {{100, 20}, {0, 20}, 0}, {{0, 20}, {0, 0}, 0.1}};
  const auto places = arrow_positions_round(round, 5, 100, kEverything);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(distance(places[0].at, {0.25 * length(round), 0}), 0, 0.01);
  EXPECT_NEAR(places[0].along.x, 1, 1e-9);
  EXPECT_NEAR(places[1].along.x, -1, 1e-9);
  const auto seen = arrow_positions_round(round, 5, 1000, {20, -5, 60, 25});
  ASSERT_EQ(seen.size(), 2u) << "one on each stretch";
  EXPECT_NEAR(distance(seen[0].at, {40, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(seen[1].at, {40, 20}), 0, 1e-9);
}

TEST(StretchesIn, LeaveAndComeBack) {
  const std::vector<Point> line{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(stretches_in(line, kEverything), (std::vector<std::vector<Point>>{line}));
  const auto parts = stretches_in(line, {-1, -1, 5, 11});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0], (std::vector<Point>{{0, 0}, {5, 0}}));
  EXPECT_EQ(parts[1], (std::vector<Point>{{5, 10}, {0, 10}}));
  EXPECT_TRUE(stretches_in(line, {20, 20, 30, 30}).empty());
  EXPECT_TRUE(stretches_in({{1, 1}}, kEverything).empty());
}

TEST(PlaceAlong, GoesRoundCorners) {
  const std::vector<Point> line{{0, 0}, {10, 0}, {10, 0}, {10, 10}};
  EXPECT_EQ(point_along(line, 0).at, (Point{0, 0}));
  EXPECT_EQ(point_along(line, 0).along, (Point{1, 0}));
  EXPECT_EQ(point_along(line, 13).at, (Point{10, 3}));
  EXPECT_EQ(point_along(line, 13).along, (Point{0, 1}));
  EXPECT_EQ(point_along(line, 30).at, (Point{10, 10}));
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
