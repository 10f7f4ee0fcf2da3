#include "tramline/tracks/envelope_side.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline {
namespace {

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

void expect_at(Point found, Point due) {
  EXPECT_NEAR(found.x, due.x, 1e-9);
  EXPECT_NEAR(found.y, due.y, 1e-9);
}

// Of a rectangle the envelope is the rectangle itself; the line from west to east has its north side on the
// left, the line back its south side.
TEST(EnvelopeSide, LiesOnTheLeftOfTheLine) {
  const Region body{rectangle(4, 4, 96, 56)};
  const auto [from, to] = envelope_side({10, 30}, {20, 30}, body);
  expect_at(from, {4, 56});
  expect_at(to, {96, 56});
  const auto [back, there] = envelope_side({20, 30}, {10, 30}, body);
  expect_at(back, {96, 4});
  expect_at(there, {4, 4});
}

// Where the line lies does not matter, only its direction.
TEST(EnvelopeSide, DoesNotDependOnThePlaceOfTheLine) {
  const Region body{rectangle(0, 0, 30, 20)};
  EXPECT_EQ(envelope_side({0, 0}, {0, 5}, body), envelope_side({700, -90}, {700, 3}, body));
}

// An L: parts of the envelope are not body. Along the line from (0, 0) to (1, 1) the envelope reaches from
// the corner (0, 40) on the left, 40/√2 m off the line, and along the line from 0 to (40 + 20)/√2 or
// (60 + 20)/√2, the larger.
TEST(EnvelopeSide, OfAnLWithALineAtHalfARightAngle) {
  const Region body{{{{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 40}, {0, 40}}, {}}};
  const auto [from, to] = envelope_side({0, 0}, {1, 1}, body);
  expect_at(from, {-20, 20});
  expect_at(to, {20, 60});
}

// The parts of a body share one envelope.
TEST(EnvelopeSide, IsOneForAllParts) {
  const auto [from, to] = envelope_side({0, 5}, {1, 5}, {rectangle(0, 0, 10, 10), rectangle(30, 20, 40, 30)});
  expect_at(from, {0, 30});
  expect_at(to, {40, 30});
}

}  // namespace
}  // namespace tramline
