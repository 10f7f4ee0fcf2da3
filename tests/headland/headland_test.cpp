// Headlands with lengths and areas known by hand (Zhou §2.3.3). Where a path turns by τ at a corner, an arc
// of radius R that touches both edges leaves R²·(tan(τ/2) − τ/2) of the corner, a quarter turn R²·(1 − π/4).

#include "tramline/headland/headland.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "headland/headland_faults.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLength = 1e-5;  // m: passes come 1e-7 m nearer to boundaries than they should
constexpr double kArea = 2e-3;    // m²
constexpr double kChords = 0.03;  // m²: chords of the body

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Field field_of(Ring outer, const std::vector<Ring>& obstacles = {}) {
  Field field;
  field.outer = std::move(outer);
  for (const Ring& ring : obstacles) field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "hole"});
  return field;
}

Ring polygon(int corners, double radius, Point centre) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(centre + radius * Point{std::cos(2 * kPi * i / corners), std::sin(2 * kPi * i / corners)});
  return ring;
}

/// With everything that has to hold for any headland.
HeadlandAndBody made(const Field& field, const HeadlandTerms& terms) {
  HeadlandAndBody headland = headland_of(field, terms);
  for (const std::string& fault : faults_of(field, terms, headland)) ADD_FAILURE() << fault;
  return headland;
}

double distance_to_path(Point p, const Path& path) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) out = std::min(out, distance_to_edge(segment, p, p));
  return out;
}

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

// About the corners of a square the pass, its outer edge and the clearance end in quarters of circles; with
// mitres all three are squares.
TEST(Headland, KeepsTheClearanceFromAnObstacle) {
  const double w = 4, clear = 1.5, side = 20;
  HeadlandTerms terms{w, 0, 0, {1}};
  terms.clearance_m = clear;
  const Field field = field_of(box(0, 0, 100, 60), {box(40, 20, 60, 40)});
  const auto grown_by = [&](double by) { return 4 * side * by + kPi * by * by; };
  const HeadlandAndBody round = made(field, terms);
  ASSERT_EQ(round.passes.size(), 1u);
  EXPECT_NEAR(length(round.passes[0].path), 4 * side + 2 * kPi * (clear + 0.5 * w), kLength);
  EXPECT_NEAR(area(round.ground), grown_by(clear + w), kChords);
  EXPECT_NEAR(round.uncovered_m2, grown_by(clear), kArea);
  EXPECT_NEAR(round.worked_m2, grown_by(clear + w) - grown_by(clear), kArea);

  terms.construction = HeadlandConstruction::kPlain;
  const auto square = [&](double by) { return (side + 2 * by) * (side + 2 * by); };
  const HeadlandAndBody plain = headland_of(field, terms);
  ASSERT_EQ(plain.passes.size(), 1u);
  EXPECT_NEAR(length(plain.passes[0].path), 4 * (side + 2 * clear + w), kLength);
  EXPECT_NEAR(area(plain.ground), square(clear + w) - square(0), kArea);
  EXPECT_NEAR(plain.uncovered_m2, square(clear) - square(0), kArea);
}

// A pass round the field keeps it too where an obstacle without passes is in its way; so does the land within
// a ring of trees.
TEST(Headland, KeepsTheClearanceFromBareObstaclesAndWithinThem) {
  HeadlandTerms terms{4, 0, 1, {0}};
  terms.clearance_m = 1;
  const HeadlandAndBody past = made(field_of(box(0, 0, 100, 60), {box(40, 2, 60, 12)}), terms);
  ASSERT_EQ(past.passes.size(), 1u);
  EXPECT_NEAR(distance_to_path({50, 12}, past.passes[0].path), 1 + 0.5 * 4, kLength);

  Field field = field_of(box(0, 0, 100, 60), {box(30, 10, 70, 50)});
  field.obstacles[0].shape.holes = {reversed(box(35, 15, 65, 45))};
  terms.obstacle_passes = {1};
  const HeadlandAndBody headland = made(field, terms);
  const auto within = std::ranges::find_if(headland.body, [](const Polygon& part) {
    return contains(part, Point{50, 30});
  });
  ASSERT_NE(within, headland.body.end());
  EXPECT_NEAR(area(*within), 28.0 * 28.0, kArea);
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

TEST(Headland, GoesRoundASquare) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {box(45, 45, 55, 55)}), {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 2u);
  const HeadlandPass& round = headland.passes[headland.passes[0].around_field ? 1 : 0];
  EXPECT_FALSE(round.around_field);
  EXPECT_EQ(round.obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(round.path), 40 + 6 * kPi, kLength);
  EXPECT_LT(signed_area(chords(round.path)), 0) << "the body is on the left";
  EXPECT_NEAR(area(headland.ground), 100 * 100 - 88 * 88 + 240 + 36 * kPi, kChords);
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36, kChords);
  ASSERT_EQ(headland.body.size(), 1u);
  EXPECT_EQ(headland.body.front().holes.size(), 1u);
}

// A pole: the smallest circle the machine can drive, about its centre.
TEST(Headland, CirclesAPole) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(49.5, 49.5, 50.5, 50.5)}), {4, 6, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_NEAR(length(headland.passes.front().path), 12 * kPi, kLength);
  EXPECT_NEAR(distance_to_path({50, 50}, headland.passes.front().path), 6, 1e-6);
  EXPECT_NEAR(area(headland.ground), 4 * 4 + 16 * kPi, kChords);
}

// A wall 10 cm thick: both corners of an end share a circle that touches 2 m beyond it.
TEST(Headland, SwingsRoundTheEndOfAWall) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(40, 50, 60, 50.1)}), {4, 6, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const Box reach = reach_of(headland.passes.front().path, 0);
  EXPECT_NEAR(reach.min_y, 50.05 - 6, 0.02);
  EXPECT_NEAR(distance_to_path({40, 50.05}, headland.passes.front().path), 2, 2e-3);
}

/// How far a path gets from y = 50 m beside the middle of a wall there, 15 m to both sides.
double farthest_beside(const Path& path) {
  double out_m = 0;
  for (const Point p : chords(path))
    if (std::abs(p.x - 50) < 15) out_m = std::max(out_m, std::abs(p.y - 50));
  return out_m;
}

// 60 m long and 10 cm thick, with a bend of 0.1 m in its middle: the circle that touches 2 m before the bend
// has its centre 4 m behind it, and reaches 10 m beyond it, where the pass on the other side goes straight
// on.
TEST(Headland, GoesStraightOnBehindABendOfAWall) {
  for (const double bend_m : {-0.1, 0.1}) {
    const Ring wall{{20, 50}, {50, 50 + bend_m}, {80, 50}, {80, 50.1}, {50, 50.1 + bend_m}, {20, 50.1}};
    const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {wall}), {4, 6, 0, {1}});
    ASSERT_EQ(headland.passes.size(), 1u);
    EXPECT_NEAR(farthest_beside(headland.passes.front().path), bend_m > 0 ? 2.2 : 2.1, 1e-3);
  }
}

TEST(Headland, GoesRoundAPond) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {polygon(48, 10, {50, 50})}), {6, 6, 1, {2}});
  ASSERT_EQ(headland.passes.size(), 3u);
  // Not the exact circles of 13 and 19 m: the first is wider at each corner by at most (6 − 3)·(1 −
  // cos 3.75°).
  EXPECT_NEAR(length(headland.passes[2].path), 2 * kPi * 19, 0.2);
  const HeadlandPass& first = headland.passes[headland.passes[0].around_field ? 1 : 0];
  EXPECT_NEAR(length(first.path), 2 * kPi * 13, 0.2);
}

// 4 m between obstacle and edge: one headland.
TEST(Headland, ReachesRoundAnObstacleNearTheEdge) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {box(45, 4, 55, 14)}), {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.passes.front().around_field);
  EXPECT_EQ(headland.passes.front().obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(area(headland.body), 88 * 88 - 22 * 8 - 60 - 18 * kPi, kChords);
  EXPECT_GT(headland.uncovered_m2, 40 + (4 - kPi) * 36) << "the land between is left";
}

// An obstacle without headland in the strip is gone round all the same; in the body it is left to the tracks.
TEST(Headland, KeepsOffObstaclesWithoutHeadland) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(45, 1, 55, 9), box(45, 45, 55, 55)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_EQ(headland.passes.front().obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(area(headland.body), 88 * 88 - 30 - 100, kChords);
}

// 18 m of room suffice for the field's two swaths and the obstacle's one; 12 m for those and an obstacle
// without.
TEST(Headland, PassesObstaclesStraight) {
  const Field field = field_of(box(0, 0, 100, 100), {box(45, 18, 55, 28), box(45, 72, 55, 88)});
  const HeadlandAndBody headland = made(field, {6, 8, 2, {1, 0}});
  ASSERT_EQ(headland.passes.size(), 3u);
  const auto once_round = [](double d) { return 4 * (100 - 2 * d) - 8 * 8 + 16 * kPi; };
  EXPECT_NEAR(length(headland.passes[0].path), once_round(3), kLength);
  EXPECT_EQ(headland.passes[1].obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(headland.passes[2].path), once_round(9), kLength);
  EXPECT_TRUE(headland.passes[2].obstacles.empty());
}

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

// All around the obstacle a gap where the machine cannot turn. One ring or two: a second works 4 m of 10 and
// 2 m again, which is worth it, but 0.9 m of 6.9 and 5.1 m again.
TEST(Headland, GoesRoundAMoat) {
  const HeadlandAndBody wide = made(field_of(box(0, 0, 100, 100), {box(10, 10, 90, 90)}), {6, 6, 1, {1}});
  ASSERT_EQ(wide.passes.size(), 2u);
  EXPECT_EQ(wide.passes[0].around_field + wide.passes[1].around_field, 1);
  EXPECT_GT(wide.overlap_m2, 4 * 80 * 2);
  const HeadlandAndBody narrow =
      made(field_of(box(0, 0, 100, 100), {box(6.9, 6.9, 93.1, 93.1)}), {6, 6, 1, {1}});
  ASSERT_EQ(narrow.passes.size(), 1u);
  EXPECT_TRUE(narrow.passes.front().around_field);
}

// 2 m between obstacle and edge all around: the second to fifth pass would lie outside.
TEST(Headland, StaysInTheField) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 30, 30), {box(2, 2, 28, 28)}), {1.5, 0, 0, {5}});
  EXPECT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.body.empty());
}

// Two squares 4 m apart: the circles of 6 m about the corners that face one another meet half-way.
TEST(Headland, GoesRoundTwoObstaclesAtOnce) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(38, 45, 48, 55), box(52, 45, 62, 55)}), {6, 0, 0, {1, 1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_EQ(headland.passes.front().obstacles, (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(length(headland.passes.front().path), 60 + 6 * kPi + 24 * std::asin(2.0 / 6), kLength);
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

std::vector<HeadlandPass> open_ones(const HeadlandAndBody& headland) {
  std::vector<HeadlandPass> out;
  for (const HeadlandPass& pass : headland.passes)
    if (!is_closed(pass)) out.push_back(pass);
  return out;
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

// An obstacle 3 m from the edge of a field without headland: nothing fits between the two. The pass is open,
// along the other three sides, and ends at the edge. Sides of 12 m, one of 15 m, and quarters of a circle
// that swing wide where the machine turns with 6 m.
TEST(Headland, PassesAnObstacleNearTheEdgeOnItsFreeSide) {
  const Field field = field_of(box(0, 0, 440, 320), {box(200, 3, 215, 15)});
  const HeadlandAndBody headland = made(field, {6, 3, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const HeadlandPass& pass = headland.passes.front();
  EXPECT_FALSE(is_closed(pass));
  EXPECT_FALSE(pass.around_field);
  EXPECT_EQ(pass.obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(pass.path), 2 * 15 + 15 + 3 * kPi, 0.01);
  EXPECT_NEAR(pass.path.front().from.y, 0, 1e-3);
  EXPECT_NEAR(pass.path.back().to.y, 0, 1e-3);
  // The ground ends on circles of 6 m about the two corners at the edge, the swath goes straight on for 3 m.
  EXPECT_NEAR(headland.overlap_m2, 2 * (6 * 3 - 0.5 * (3 * std::sqrt(27.0) + 36 * kPi / 6)), kChords);
  // All but the 3 m between obstacle and edge.
  EXPECT_NEAR(headland.uncovered_m2, 15 * 3, 0.1);
  const Field in_corner = field_of(box(0, 0, 440, 320), {box(3, 3, 18, 15)});
  const HeadlandAndBody corner = made(in_corner, {6, 3, 0, {1}});
  ASSERT_EQ(corner.passes.size(), 1u);
  EXPECT_NEAR(length(corner.passes.front().path), 18 + 15 + 1.5 * kPi, 0.01);
}

// There is room for a swath between obstacle and edge, 8 m: it is driven round.
TEST(Headland, DrivesRoundAnObstacleWithRoomBehindIt) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 440, 320), {box(200, 8, 215, 20)}), {6, 3, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(is_closed(headland.passes.front()));
}

// A wall of 300 m along the edge has no headland: the ring round the field would follow it for as long, on
// ground that the body has. It ends at the wall instead.
TEST(Headland, EndsAtALongObstacleWithoutHeadland) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 440, 320), {box(70, 2, 370, 8)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_FALSE(is_closed(headland.passes.front()));
  EXPECT_LT(length(headland.passes.front().path), 2 * (440 + 320) - 300);
  EXPECT_LT(headland.overlap_m2, 300);
}

// A block of 32 m by 39 m close to the edge has a recess 12 m wide and 7 m deep on the edge's side, and a
// post stands in the recess. The pass ends at the block on either side; none goes into the recess, over the
// post.
TEST(Headland, KeepsOutOfARecessWithAPostInIt) {
  const Ring block{{60, 1}, {70, 1}, {70, 7}, {82, 7}, {82, 1}, {92, 1}, {92, 40}, {60, 40}};
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 200, 120), {block, box(75, 1.5, 77, 3)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_FALSE(is_closed(headland.passes.front()));
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

TEST(Headland, MayTakeTheWholeField) {
  const Field field = field_of(box(0, 0, 20, 20));
  const HeadlandAndBody headland = made(field, {6, 0, 2, {}});
  EXPECT_TRUE(headland.body.empty());
  EXPECT_NEAR(area(headland.ground), 400, 1e-6);
  ASSERT_EQ(headland.passes.size(), 1u) << "the second does not fit";
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36 + 8 * 8, kArea);
}

TEST(Headland, FitsWhereItJustFits) {
  const HeadlandAndBody square = made(field_of(box(0, 0, 24, 24)), {6, 0, 2, {}});
  ASSERT_EQ(square.passes.size(), 2u);
  EXPECT_NEAR(length(square.passes.back().path), 6 * kPi, kLength);
  const HeadlandAndBody strip = made(field_of(box(0, 0, 60, 12)), {6, 0, 1, {}});
  ASSERT_EQ(strip.passes.size(), 1u);
  EXPECT_NEAR(length(strip.passes.front().path), 2 * 48 + 6 * kPi, kLength);
}

TEST(Headland, IsNotWorkedOnPassableLand) {
  Field field = field_of(box(0, 0, 100, 60), {box(48, 0, 52, 60)});
  field.obstacles.front().kind = ObstacleKind::kPassable;
  const HeadlandAndBody headland = made(field, {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.passes.front().obstacles.empty());
  EXPECT_NEAR(headland.worked_m2, 6 * length(headland.passes.front().path) - 2 * 4 * 6, kArea);
  EXPECT_NEAR(area(headland.body), 88 * 48 - 4 * 48, kArea);
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36, kArea);
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

TEST(Headland, LeavesLandInsideAnObstacleAlone) {
  Field field = field_of(box(0, 0, 100, 100), {box(40, 40, 60, 60)});
  field.obstacles.front().shape.holes.push_back(reversed(box(45, 45, 55, 55)));
  const HeadlandAndBody headland = made(field, {6, 0, 1, {1}});
  EXPECT_EQ(headland.passes.size(), 2u);
  EXPECT_EQ(headland.body.size(), 2u);
  EXPECT_NEAR(area(headland.body), 88 * 88 - 400 - 480 - 36 * kPi + 100, kChords);
}

TEST(MostPasses, LeaveABody) {
  EXPECT_EQ(most_passes(field_of(box(0, 0, 100, 60)), 6), 4) << "the fifth takes the last 0 m";
  EXPECT_EQ(most_passes(field_of(box(0, 0, 20, 20)), 6), 1);
  EXPECT_EQ(most_passes(field_of(box(0, 0, 10, 10)), 6), 0);
  EXPECT_EQ(most_passes(field_of(box(0, 0, 100, 60), {box(40, 20, 60, 40)}), 6), 4);
}

}  // namespace
}  // namespace tramline::testing
