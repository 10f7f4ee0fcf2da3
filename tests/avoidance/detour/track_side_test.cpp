// Sides of straight and of curved tracks, and the detours beside them, against closed forms.

#include "tramline/avoidance/detour/track_side.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline {
namespace {

constexpr double kSwathWidth = 3;

/// Strip 2 is x from 6 to 9.
const StripGrid kStrips{TrackFrame(), 0, kSwathWidth};

Track straight_track() {
  Track out;
  out.index = 2;
  return out;
}

/// A quarter of a circle of 50 m about the origin, anticlockwise from (50, 0).
Track quarter() {
  Track out;
  out.path = {{{50, 0}, {0, 50}, 1 / 50.0}};
  out.length_m = 25 * std::numbers::pi;
  return out;
}

TEST(TrackSide, OfAStraightTrackHasYToTheSideOfPassing) {
  const TrackSide left = track_side(kStrips, straight_track(), {40, 44}, Passing::kLeft);
  EXPECT_FALSE(left.curve);
  EXPECT_EQ(left.width_m, kSwathWidth);
  EXPECT_EQ(left.frame.to_detour({7.5, 40}), (Point{40, 0}));
  EXPECT_EQ(left.frame.to_detour({5.5, 40}), (Point{40, 2}));
  const TrackSide right = track_side(kStrips, straight_track(), {40, 44}, Passing::kRight);
  EXPECT_EQ(right.frame.to_detour({9.5, 40}), (Point{40, 2}));
  EXPECT_EQ(right.frame.to_plane(Point{40, 2}), (Point{9.5, 40}));
}

// Blocked from 45° to 45° round: there the track runs north-west, and the origin lies on its left.
TEST(TrackSide, OfACurveTouchesItInTheMiddleOfWhatIsInTheWay) {
  const double middle_m = 12.5 * std::numbers::pi;
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    const TrackSide track = track_side(kStrips, quarter(), {middle_m - 3, middle_m + 3}, side);
    const double half = 50 / std::sqrt(2.0), sense = side == Passing::kLeft ? 1 : -1;
    EXPECT_NEAR(distance(track.frame.to_detour({half, half}), {0, 0}), 0, 1e-9);
    EXPECT_NEAR(distance(track.frame.to_detour({0, 0}), {0, sense * 50}), 0, 1e-9);
    ASSERT_TRUE(track.curve);
    EXPECT_EQ(track.curve->blocked_from, middle_m - 3);
    EXPECT_EQ(track.curve->blocked_to, middle_m + 3);
    const PathPoint on = track.curve->measured.at(middle_m);
    EXPECT_NEAR(distance(on.at, {0, 0}), 0, 1e-9);
    EXPECT_NEAR(distance(on.heading, {1, 0}), 0, 1e-9);
  }
}

TEST(TrackSide, ReachesHalfAWidthToBothSides) {
  const Box box = reach_between(track_side(kStrips, straight_track(), {40, 44}, Passing::kLeft), {38, 47});
  EXPECT_EQ(box.min_x, 38);
  EXPECT_EQ(box.max_x, 47);
  EXPECT_EQ(box.min_y, -1.5);
  EXPECT_EQ(box.max_y, 1.5);
}

// 10 m to either side of the middle the curve has turned by 0.2 rad, to the side of passing. Its ends are
// looked at, so the box is exact there; the lowest point lies between two looks at the most half a metre off.
TEST(TrackSide, ReachesAlongTheCurve) {
  const double middle_m = 12.5 * std::numbers::pi;
  const Box box = reach_between(track_side(kStrips, quarter(), {middle_m - 3, middle_m + 3}, Passing::kLeft),
                                {middle_m - 10, middle_m + 10});
  EXPECT_NEAR(box.max_y, 50 - 48.5 * std::cos(0.2), 1e-9);
  EXPECT_NEAR(box.max_x, 51.5 * std::sin(0.2), 1e-9);
  EXPECT_NEAR(box.min_x, -51.5 * std::sin(0.2), 1e-9);
  EXPECT_NEAR(box.min_y, -1.5, 0.5 * 0.5 / (2 * 50));
}

// A pole of 1 m on the line at y = 42: ρ = 2.5 m, r = 6 m, √(4·6·2.5 − 2.5²) before and behind.
TEST(TrackSide, ADetourBesideAStraightTrackIsBackInItsPlane) {
  const double half = std::sqrt(60 - 6.25);
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    const TrackSide track = track_side(kStrips, straight_track(), {40, 44}, side);
    const auto detour = detour_beside(track, {{{42, 0}, 2.5}}, 6, HullCorners::kDrivable);
    ASSERT_TRUE(detour);
    EXPECT_EQ(detour->side, side);
    EXPECT_NEAR(detour->from, 42 - half, 1e-9);
    EXPECT_NEAR(detour->to, 42 + half, 1e-9);
    EXPECT_NEAR(distance(detour->path.front().from, {7.5, 42 - half}), 0, 1e-9);
    EXPECT_NEAR(distance(detour->path.back().to, {7.5, 42 + half}), 0, 1e-9);
    const double sense = side == Passing::kLeft ? 1 : -1;
    EXPECT_NEAR(detour->path.front().curvature, sense / 6, 1e-12);
    EXPECT_NEAR(detour->length_m, 4 * 6 * std::acos(1 - 2.5 / 12), 1e-9);
  }
}

// Round a pole of ρ = 8 m on the curve's line the triangle of centres has the sides 50, r + ρ and 50 ∓ r, −
// to the inside: the path leaves the track by the angle at the origin before the pole.
TEST(TrackSide, ADetourBesideACurveLeavesItByTheTriangleOfCentres) {
  const double middle_m = 12.5 * std::numbers::pi, r = 6, rho = 8;
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    const TrackSide track = track_side(kStrips, quarter(), {middle_m - 3, middle_m + 3}, side);
    const auto detour = detour_beside(track, {{{0, 0}, rho}}, r, HullCorners::kDrivable);
    ASSERT_TRUE(detour);
    const double other = side == Passing::kLeft ? 50 - r : 50 + r;
    const double angle = std::acos((2500 + other * other - (r + rho) * (r + rho)) / (2 * 50 * other));
    EXPECT_NEAR(detour->from, middle_m - 50 * angle, 1e-6);
    EXPECT_NEAR(detour->to, middle_m + 50 * angle, 1e-6);
    EXPECT_NEAR(length(detour->path.front().from), 50, 1e-6) << "on the track";
  }
}

TEST(TrackSide, HasNoDetourWhereNothingReachesOverTheTrack) {
  const TrackSide track = track_side(kStrips, straight_track(), {40, 44}, Passing::kLeft);
  EXPECT_FALSE(detour_beside(track, {{{42, -3}, 2.5}}, 6, HullCorners::kDrivable));
}

}  // namespace
}  // namespace tramline
