#include "tramline/cost/gain_by_detours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline {
namespace {

constexpr double kWidth = 4;
const Region kBody{{{{0, -50}, {100, -50}, {100, 50}, {0, 50}}, {}}};

/// Along y = `at`, with half a circle of radius 10 m between two quarters, to the left or to the right.
TrackPiece round_piece(double at, double left) {
  TrackPiece out{{0, at}, {100, at}};
  const auto y = [&](double up) { return at + left * up; };
  Detour detour;
  detour.path = {{{30, y(0)}, {40, y(10)}, left * 0.1},
                 {{40, y(10)}, {50, y(20)}, -left * 0.1},
                 {{50, y(20)}, {60, y(10)}, -left * 0.1},
                 {{60, y(10)}, {70, y(0)}, left * 0.1}};
  out.curve = {{{0, y(0)}, {30, y(0)}}};
  out.curve.insert(out.curve.end(), detour.path.begin(), detour.path.end());
  out.curve.push_back({{70, y(0)}, {100, y(0)}});
  out.detours = {detour};
  return out;
}

TrackPiece plain_piece(double at) {
  TrackPiece out{{0, at}, {100, at}};
  out.curve = straight_path(out.start, out.end);
  return out;
}

// Two quarters and a half circle of radius 10 m, 4 m wide.
const double kDetour_m2 = kWidth * 20 * std::numbers::pi;
// At its top the detour runs round (50, 10) between 8 and 12 m. A swath from 18 to 22 m takes the cap of the
// larger circle that is more than 8 m above the centre.
const double kCap_m2 = 144 * std::acos(8.0 / 12) - 8 * std::sqrt(144.0 - 64);
// A swath from 14 to 18 m, more than 4 m above the centre, takes the next 4 m of that but for the cap of the
// smaller circle.
const double kBelowCap_m2 = 144 * std::acos(4.0 / 12) - 4 * std::sqrt(144.0 - 16) - kCap_m2 -
                            (64 * std::acos(4.0 / 8) - 4 * std::sqrt(64.0 - 16));

void expect_gains(const std::vector<TrackPiece>& pieces, const std::vector<double>& expected) {
  const std::vector<double> found = gain_by_detours_m2(kBody, pieces, kWidth);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

TEST(GainByDetours, is_nothing_without_them) { expect_gains({plain_piece(0), plain_piece(4)}, {0, 0}); }

TEST(GainByDetours, is_the_detour_where_nothing_else_works) {
  expect_gains({round_piece(0, 1)}, {kDetour_m2});
}

// Whoever comes later works in vain what they share.
TEST(GainByDetours, goes_to_the_first_in_driving_order) {
  const TrackPiece round = round_piece(0, 1), top = plain_piece(20), below = plain_piece(16);
  expect_gains({round, top, below}, {kDetour_m2, -kCap_m2, -kBelowCap_m2});
  expect_gains({top, below, round}, {0, 0, kDetour_m2 - kCap_m2 - kBelowCap_m2});
  expect_gains({top, round, below}, {0, kDetour_m2 - kCap_m2, -kBelowCap_m2});
}

// From y = 40 another comes down on the first: their tops lie over one another. What two detours have in
// common is lost once, to the second, and a later swath loses all that either has of it, but not twice.
TEST(GainByDetours, counts_ground_of_two_detours_once) {
  const TrackPiece up = round_piece(0, 1), down = round_piece(40, -1), between = plain_piece(20);
  // Above y = 20 the first detour has the cap of its larger circle that is more than 10 m above its centre;
  // the second has as much below, and what they share is both.
  const double above_m2 = 144 * std::acos(10.0 / 12) - 10 * std::sqrt(144.0 - 100), shared_m2 = 2 * above_m2;
  // Either cap reaches from 18 to 22 m, and so does the swath between: it holds all they share.
  const double either_m2 = 2 * kCap_m2 - shared_m2;
  expect_gains({up, down, between}, {kDetour_m2, kDetour_m2 - shared_m2, -either_m2});
  expect_gains({between, up, down}, {0, kDetour_m2 - kCap_m2, kDetour_m2 - kCap_m2});
  expect_gains({up, between, down}, {kDetour_m2, -kCap_m2, kDetour_m2 - kCap_m2});
}

// Below y = 12 alone there is anything to work: the detour's own half circle begins 2 m lower.
TEST(GainByDetours, knows_the_body) {
  const Region low{{{{0, -50}, {100, -50}, {100, 10}, {0, 10}}, {}}};
  const std::vector<double> found = gain_by_detours_m2(low, {round_piece(0, 1)}, kWidth);
  EXPECT_NEAR(found[0], 0.5 * kDetour_m2, 1e-9);
}

}  // namespace
}  // namespace tramline
