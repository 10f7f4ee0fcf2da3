#include "tramline/geometry/path/smoothed_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/drivable.h"
#include "tramline/geometry/error.h"

namespace tramline::smoothed_line_test {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 6;

std::string complaint_about(const std::vector<Point>& line) {
  try {
    smoothed(line, kRadius);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "";
}

TEST(Smoothed, LeavesAStraightLineAlone) {
  const Smoothed out = smoothed({{0, 0}, {0, 0}, {10, 0}, {10, 1e-8}, {30, 0}, {40, 0}, {40, 0}}, kRadius);
  ASSERT_EQ(out.path.size(), 1u);
  EXPECT_EQ(out.path.front(), (PathSegment{{0, 0}, {40, 0}, 0}));
  EXPECT_NEAR(out.deviation_m, 0, 1e-7);
}

// A right angle: tangents of length r, an arc that leaves the vertex by r·(√2 − 1).
TEST(Smoothed, RoundsAKink) {
  const Smoothed out = smoothed({{0, 0}, {50, 0}, {50, 40}}, kRadius);
  ASSERT_EQ(out.path.size(), 3u);
  EXPECT_NEAR(length(out.path), 44 + 34 + 3 * kPi, 1e-9);
  EXPECT_NEAR(out.path[1].from.x, 44, 1e-9);
  EXPECT_NEAR(out.path[1].curvature, 1 / kRadius, 1e-12);
  EXPECT_NEAR(out.deviation_m, kRadius * (std::sqrt(2.) - 1), 2e-4);
  EXPECT_NEAR(distance(out.worst, {50, 0}), 0, 1e-9);
}

// The disc touches the legs and not the short edge that cuts the corner (0.7071, 0) off.
TEST(Smoothed, BridgesAShortEdgeThatTurnsTheSameWayTwice) {
  const double h = std::sqrt(0.5);
  const Smoothed out = smoothed({{-40, 0}, {0, 0}, {h, h}, {h, 40}}, kRadius);
  ASSERT_EQ(out.path.size(), 3u);
  EXPECT_NEAR(distance(centre(out.path[1]), {h - kRadius, kRadius}), 0, 1e-9);
  EXPECT_NEAR(out.deviation_m, std::hypot(kRadius - h, kRadius) - kRadius, 2e-4);
}

// Two parallel lines half a metre apart: the machine changes over within a few metres, and far from the
// jog it stays on the lines.
TEST(Smoothed, DrawsOppositeKinksApart) {
  const Smoothed out = smoothed({{-60, 0}, {0, 0}, {0, 0.5}, {60, 0.5}}, kRadius);
  expect_drivable(out.path, kRadius);
  EXPECT_LE(out.deviation_m, 0.25 + 1e-3);
  EXPECT_EQ(out.path.front().to.y, 0);
  EXPECT_GT(out.path.front().to.x, -5);
  EXPECT_LT(out.path.back().from.x, 5);
}

// A saw's teeth are no shape to follow.
TEST(Smoothed, AveragesASaw) {
  std::vector<Point> line{{0, 0}};
  for (int i = 1; i < 400; ++i) line.push_back({0.2 * i, i % 2 == 0 ? 0.05 : -0.05});
  line.push_back({80, 0});
  const Smoothed out = smoothed(line, kRadius);
  expect_drivable(out.path, kRadius);
  EXPECT_LT(out.deviation_m, 0.15);
}

// Chords of a circle become arcs of about its radius, not kinks of the machine's.
TEST(Smoothed, FindsTheArcInAPolyline) {
  std::vector<Point> line;
  for (int i = 0; i <= 200; ++i) line.push_back({50 * std::cos(0.01 * i), 50 * std::sin(0.01 * i)});
  const Smoothed out = smoothed(line, kRadius, 0.02);
  expect_drivable(out.path, 40);
  EXPECT_LT(out.deviation_m, 0.03);
  EXPECT_NEAR(length(out.path), 100, 0.05);
}

TEST(Smoothed, KeepsAUTurnThatCanBeDriven) {
  std::vector<Point> line{{0, -50}};
  for (int i = 0; i <= 40; ++i) line.push_back({-7 + 7 * std::cos(i * kPi / 40), 7 * std::sin(i * kPi / 40)});
  line.push_back({-14, -50});
  const Smoothed out = smoothed(line, kRadius);
  expect_drivable(out.path, kRadius);
  EXPECT_LT(out.deviation_m, 0.05);
}

// A day's log: thousands of points a few centimetres off the way driven, some of them twice.
TEST(Smoothed, FollowsARecordedDrive) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 0.03);
  std::vector<Point> line;
  for (int i = 0; i < 5000; ++i) {
    const double x = 0.4 * i;
    line.push_back({x + 0.1 * noise(random), 60 * std::sin(x / 120) + noise(random)});
    if (i % 50 == 0) line.push_back(line.back());
  }
  for (const double tolerance : {0.0, 0.1, 0.5}) {
    const Smoothed out = smoothed(line, kRadius, tolerance);
    expect_drivable(out.path, kRadius);
    EXPECT_EQ(out.path.front().from, line.front());
    EXPECT_EQ(out.path.back().to, line.back());
    EXPECT_LT(out.deviation_m, 0.3 + 2 * tolerance) << tolerance;
    EXPECT_LT(out.path.size(), tolerance > 0 ? 1500u : 10000u);
  }
}

TEST(Smoothed, SaysWhatIsWrongWithTheLine) {
  EXPECT_NE(complaint_about({{1, 1}}).find("two points"), std::string::npos);
  EXPECT_NE(complaint_about({{1, 1}, {1, 1}, {1, 1 + 1e-9}}).find("two points"), std::string::npos);
  EXPECT_NE(complaint_about({{0, 0}, {0, 0}, {50, 0}, {50, 50}, {20, -30}}).find("vertices 0 and 3"),
            std::string::npos);
  EXPECT_NE(complaint_about({{0, 0}, {100, 0}, {0, 1}}).find("vertex 1 "), std::string::npos);
  EXPECT_NE(complaint_about({{0, 0}, {100, 0}, {100, 5}, {0, 5}}).find("vertex "), std::string::npos);
}

}  // namespace tramline::smoothed_line_test
