#include "tramline/geometry/path/segment_frame.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::segment_frame_test {

using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

void expect_at(Point p, Point expected) { EXPECT_LT(distance(p, expected), 1e-9) << p.x << " " << p.y; }

// North from (5, 10): the left end of a cross-section 4 m long lies at x = 3.
TEST(SegmentFrame, MeasuresALineToTheRightAndAlong) {
  const SegmentFrame frame({{5, 10}, {5, 30}, 0}, 2);
  EXPECT_TRUE(frame.straight());
  EXPECT_EQ(frame.length(), 20);
  expect_at(frame.local({6, 13}), {1, 3});
  EXPECT_NEAR(frame.across(frame.local({6, 13})), 3, 1e-12);
  EXPECT_NEAR(frame.along(frame.local({6, 13})), 3, 1e-12);
  expect_at(frame.point_at(3, 0), {3, 13});
  expect_at(frame.point_at(20, 4), {7, 30});
}

// A quarter about the origin from (10, 0) to (0, 10): its right side is the outside.
TEST(SegmentFrame, MeasuresAnArcToTheLeft) {
  const SegmentFrame frame({{10, 0}, {0, 10}, 0.1}, 2);
  EXPECT_FALSE(frame.straight());
  EXPECT_EQ(frame.sense(), 1);
  EXPECT_NEAR(frame.radius(), 10, 1e-12);
  EXPECT_NEAR(frame.half_turn(), kPi / 4, 1e-12);
  EXPECT_NEAR(frame.length(), 5 * kPi, 1e-12);
  const double half = std::sqrt(0.5);
  expect_at(frame.local({7 * half, 7 * half}), {7, 0});
  expect_at(frame.local({-3 * half, 3 * half}), {0, 3});
  for (const double angle : {0.0, 0.3, 1.5})
    for (const double across : {0.0, 1.0, 4.0}) {
      const Point p = turned({10 + across - 2, 0}, angle);
      expect_at(frame.point_at(10 * angle, across), p);
      EXPECT_NEAR(frame.across(frame.local(p)), across, 1e-12);
      EXPECT_NEAR(frame.along(frame.local(p)), 10 * angle, 1e-12);
    }
}

// The same quarter driven back: its right side is the inside.
TEST(SegmentFrame, MeasuresAnArcToTheRight) {
  const SegmentFrame frame({{0, 10}, {10, 0}, -0.1}, 2);
  EXPECT_EQ(frame.sense(), -1);
  EXPECT_NEAR(frame.half_turn(), kPi / 4, 1e-12);
  const double half = std::sqrt(0.5);
  expect_at(frame.local({7 * half, 7 * half}), {7, 0});
  expect_at(frame.local({3 * half, -3 * half}), {0, 3});
  for (const double angle : {0.0, 0.3, 1.5})
    for (const double across : {0.0, 1.0, 4.0}) {
      const Point p = turned({0, 10 - across + 2}, -angle);
      expect_at(frame.point_at(10 * angle, across), p);
      EXPECT_NEAR(frame.across(frame.local(p)), across, 1e-12);
      EXPECT_NEAR(frame.along(frame.local(p)), 10 * angle, 1e-12);
    }
}

// Ends that lie a little farther apart than the diameter are half a circle, too.
TEST(SegmentFrame, TakesHalfACircle) {
  for (const double beyond : {0.0, 1e-12}) {
    const SegmentFrame frame({{10 + beyond, 0}, {-10, 0}, 0.1}, 2);
    EXPECT_NEAR(frame.length(), 10 * kPi, 1e-9);
    expect_at(frame.point_at(5 * kPi, 2), {0, 10});
    expect_at(frame.point_at(0, 4), {12, 0});
  }
}

TEST(SegmentFrame, FindsBackToTheField) {
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const double half_width = random.between(0.5, 4);
    for (const PathSegment& segment : testing::random_smooth_path(random, 5, 4)) {
      const SegmentFrame frame(segment, half_width);
      EXPECT_NEAR(frame.length(), length(segment), 1e-9);
      expect_at(frame.point_at(0, half_width), segment.from);
      expect_at(frame.point_at(frame.length(), half_width), segment.to);
      expect_at(frame.point_at(0, 0), segment.from + half_width * left_of(direction_at_start(segment)));
      expect_at(frame.point_at(frame.length(), 2 * half_width),
                segment.to - half_width * left_of(direction_at_end(segment)));
      for (int i = 0; i < 20; ++i) {
        const double along = random.between(0, frame.length()), across = random.between(0, 2 * half_width);
        const Point q = frame.local(frame.point_at(along, across));
        EXPECT_NEAR(frame.along(q), along, 1e-8);
        EXPECT_NEAR(frame.across(q), across, 1e-9);
      }
    }
  }
}

}  // namespace tramline::segment_frame_test
