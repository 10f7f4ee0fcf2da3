// Which side of a detour things are on. The detour leaves a track along x = 0 to the left by 2 m on arcs of
// 10 m: √(4·10·2 − 2²) = 8.718 m before and behind y = 50.

#include "tramline/avoidance/detour/goes_round.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/box_ring.h"
#include "tramline/avoidance/detour/detour_frame.h"
#include "tramline/avoidance/detour/detour_path.h"

namespace tramline::goes_round_test {

using testing_support::box;

TrackDetour detour(Passing side) {
  TrackDetour out;
  out.side = side;
  out.path = DetourFrame(0, side).to_plane(detour_path({{{50, 1}, 1}}, 10).value());
  out.from = 50 - std::sqrt(76);
  out.to = 50 + std::sqrt(76);
  return out;
}

TEST(GoesRound, WhatLiesRightOfADetourToTheLeft) {
  const TrackDetour left = detour(Passing::kLeft);
  EXPECT_TRUE(goes_round(left, box(-1.9, 49.9, -1.8, 50.1))) << "just below the peak";
  EXPECT_FALSE(goes_round(left, box(-2.2, 49.9, -2.1, 50.1))) << "just above it";
  EXPECT_TRUE(goes_round(left, box(3, 45, 4, 46)));
  EXPECT_FALSE(goes_round(left, box(-9, 45, -8, 46)));
}

// The outer arcs are 10 − √(10² − 2²) = 0.202 m off the track 2 m from their ends.
TEST(GoesRound, FollowsTheArcs) {
  const TrackDetour left = detour(Passing::kLeft);
  for (const double y : {left.from + 2, left.to - 2}) {
    EXPECT_TRUE(goes_round(left, box(-0.19, y - 0.01, 0, y + 0.01)));
    EXPECT_FALSE(goes_round(left, box(-1, y - 0.01, -0.21, y + 0.01)));
  }
}

TEST(GoesRound, NothingBeforeOrBehindIt) {
  const TrackDetour left = detour(Passing::kLeft);
  EXPECT_FALSE(goes_round(left, box(3, 30, 4, 41.2)));
  EXPECT_FALSE(goes_round(left, box(3, 58.8, 4, 70)));
  EXPECT_TRUE(goes_round(left, box(3, 30, 4, 41.4))) << "it reaches past the beginning";
}

TEST(GoesRound, MirroredToTheRight) {
  const TrackDetour right = detour(Passing::kRight);
  EXPECT_TRUE(goes_round(right, box(1.8, 49.9, 1.9, 50.1)));
  EXPECT_FALSE(goes_round(right, box(2.1, 49.9, 2.2, 50.1)));
  EXPECT_TRUE(goes_round(right, box(-4, 45, -3, 46)));
  EXPECT_FALSE(goes_round(right, box(8, 45, 9, 46)));
}

}  // namespace tramline::goes_round_test
