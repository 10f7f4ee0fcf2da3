// How far open passes are driven on at their ends.

#include "tramline/headland/driven_on.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/path/path.h"

namespace tramline {
namespace {

constexpr double kWidth_m = 6, kRadius_m = 8, kMost_m = 12;

/// A pass of 10 m to the east that ends in (0, 0).
Path pass_to_the_east() { return {{{-10, 0}, {0, 0}, 0}}; }

double gone_on_m(const std::vector<SwathLimit>& limits) {
  return driven_to_the_end(pass_to_the_east(), limits, {kWidth_m, kRadius_m, kMost_m}).back().to.x;
}

/// Land behind x = 7, and land north of a line that falls by 1 in 10 from (0, 9).
const Ring kAhead{{7, -20}, {30, -20}, {30, 20}, {7, 20}};
const Ring kBeside{{0, 9}, {60, 3}, {60, 40}, {0, 40}};

TEST(DrivenToTheEnd, GoesOnUntilTheSwathTouchesWhatIsAhead) {
  EXPECT_NEAR(gone_on_m({}), kMost_m, 1e-9);
  EXPECT_NEAR(gone_on_m({{kAhead, 0}}), 7, 1e-6);
  EXPECT_NEAR(gone_on_m({{kBeside, 0}}), kMost_m, 1e-6) << "6 m from the swath";
}

// The front left corner of the swath, (run, 3), is (6 − run/10)/√1.01 from the line.
TEST(DrivenToTheEnd, KeepsADistanceBesideTheSwathToo) {
  EXPECT_NEAR(gone_on_m({{kBeside, 5}}), 10 * (6 - 5 * std::sqrt(1.01)), 2e-3);
  EXPECT_NEAR(gone_on_m({{kBeside, 5.9}}), 10 * (6 - 5.9 * std::sqrt(1.01)), 2e-3);
  EXPECT_NEAR(gone_on_m({{kAhead, 4}}), 3, 2e-3);
  EXPECT_EQ(gone_on_m({{kBeside, 8}}), 0) << "too near already";
}

/// Land beside a pass to the east, on its right: its edge turns towards the pass at (5, −3).
Ring bending(double angle) {
  const Point along{std::cos(angle), std::sin(angle)};
  const Point bend{5, -3};
  return {{-20, -3}, {-20, -40}, {60, -40}, bend + 55.0 * along, bend};
}

Path driven_beside(const Ring& ring, Along boundary) {
  return driven_on(pass_to_the_east(), {{ring, 0}}, {kWidth_m, kRadius_m, kMost_m, boundary});
}

// The lines half a width from both edges cross at (5 − 3·tan ½φ, 0); the arc begins and ends 8·tan ½φ from
// there, and is shorter than these by 8·(2·tan ½φ − φ).
TEST(DrivenOn, GoesAlongABoundaryThatBends) {
  constexpr double kAngle = 0.2;
  const double slope = std::tan(0.5 * kAngle);
  const Path path = driven_beside(bending(kAngle), Along::kOnTheRight);
  ASSERT_EQ(path.size(), 3U);
  EXPECT_NEAR(path[0].to.x, 5 - (3 + kRadius_m) * slope, 1e-3) << "0.1 mm of the boundary may be beside it";
  EXPECT_NEAR(1 / path[1].curvature, kRadius_m, 1e-9);
  EXPECT_NEAR(turning(path[1]), kAngle, 1e-9);
  EXPECT_NEAR(length(path), 10 + kMost_m, 1e-9);
  const Point along{std::cos(kAngle), std::sin(kAngle)};
  EXPECT_NEAR(cross(along, path.back().to - Point{5, -3}), 0.5 * kWidth_m, 1e-3) << "from the edge";
}

TEST(DrivenOn, StopsAtABoundaryThatItDoesNotGoAlong) {
  for (const Along boundary : {Along::kNone, Along::kOnTheLeft})
    EXPECT_NEAR(length(driven_beside(bending(0.2), boundary)), 15, 1e-3);
}

TEST(DrivenOn, StopsAtACorner) {
  EXPECT_NEAR(length(driven_beside(bending(0.55), Along::kOnTheRight)), 15, 1e-3);
}

// The arc ends on a line through (5.49, 0.16) at right angles to the bent edge: a mast between that and the
// bend would be driven over by the arc alone.
TEST(DrivenOn, StopsBeforeWhatTheTurnWouldDriveOver) {
  const Ring mast{{5.1, 1}, {5.2, 1}, {5.2, 1.1}, {5.1, 1.1}};
  const Path path = driven_on(pass_to_the_east(), {{bending(0.2), 0}, {mast, 0}},
                              {kWidth_m, kRadius_m, kMost_m, Along::kOnTheRight});
  EXPECT_NEAR(length(path), 15, 1e-3);
}

TEST(DrivenOn, StopsWhereItHasNoLineToTurnFrom) {
  const Path shorter{{{-0.5, 0}, {0, 0}, 0}};
  const Ring ring{{-20, -3}, {-20, -40}, {60, -40}, {60, 12}, {0.3, -3}};
  const Path path = driven_on(shorter, {{ring, 0}}, {kWidth_m, kRadius_m, kMost_m, Along::kOnTheRight});
  EXPECT_NEAR(length(path), 0.8, 1e-3);
}

TEST(DrivenToTheEnd, HasTheBoundaryOnTheOtherSideAtItsBeginning) {
  Ring mirrored;
  for (const Point p : bending(0.2)) mirrored.push_back({-10 - p.x, p.y});
  const Path path = driven_to_the_end(pass_to_the_east(), {{mirrored, 0}},
                                      {kWidth_m, kRadius_m, kMost_m, Along::kOnTheRight});
  EXPECT_NEAR(length(path), 10 + 2 * kMost_m, 1e-9);
  const Point end = driven_beside(bending(0.2), Along::kOnTheRight).back().to;
  EXPECT_NEAR(path.front().from.x, -10 - end.x, 1e-6);
  EXPECT_NEAR(path.front().from.y, end.y, 1e-6);
}

}  // namespace
}  // namespace tramline
