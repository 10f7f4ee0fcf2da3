// How long detours are at least, by hand.

#include "tramline/cost/bound/detour_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline {
namespace {

TEST(DetourLength, IsThatOfTwoChordsPastOnePoint) {
  // 3-4-5: up by 3 over 4 and down again. A point has no width to keep from it.
  EXPECT_NEAR(least_longer_m({{0, 3}}, 0, {-4, 4}), 2, 1e-12);
  EXPECT_NEAR(least_longer_m({{0, 3}, {1, 0}, {0, -5}}, 0, {-4, 4}), 2, 1e-12) << "others lie below";
}

TEST(DetourLength, GoesRoundTheDiscOfHalfAWidth) {
  // A string from (-5, 0) over a disc of radius 3 about the middle of the track, and back to (5, 0): two
  // tangents of length 4 and the arc between them. Corners of the disc are cut.
  const double string_m = 8 + 3 * 2 * (std::numbers::pi / 2 - std::acos(3.0 / 5));
  const double least = least_longer_m({{0, 0}}, 3, {-5, 5});
  EXPECT_LE(least, string_m - 10);
  EXPECT_GE(least, 0.9 * (string_m - 10));
}

TEST(DetourLength, IsNothingPastWhatTheTrackClears) {
  EXPECT_EQ(least_longer_m({{0, -2}}, 1.5, {-10, 10}), 0);
  EXPECT_EQ(least_longer_m({}, 1.5, {-10, 10}), 0);
}

}  // namespace
}  // namespace tramline
