// The words of Dubins and of Reeds and Shepp: known lengths, every word driven in small steps, symmetries.

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "turns/expect_manoeuvre.h"

namespace tramline {
namespace {

using testing::expect_leads;
using testing::expect_no_tighter;
using testing::pose;

constexpr double kWordPi = std::numbers::pi;

TEST(Dubins, WaysKnownByHand) {
  // straight on; a quarter circle
  EXPECT_NEAR(dubins_length(pose(0, 0, 30), pose(20, 20 * std::sqrt(3.0), 30), 6), 40, 1e-9);
  EXPECT_EQ(shortest_dubins(pose(0, 0, 30), pose(20, 20 * std::sqrt(3.0), 30), 6).word, "S");
  EXPECT_NEAR(dubins_length(pose(0, 0, 0), pose(6, 6, 90), 6), 3 * kWordPi, 1e-9);
  EXPECT_EQ(shortest_dubins(pose(0, 0, 0), pose(6, 6, 90), 6).word, "R");
  // 40 m to the right and 30 m on: from the centre (6, 0) to (34, 30), whose inner tangent is √(28² + 30² −
  // 12²)
  const double line = std::sqrt(28.0 * 28 + 30 * 30 - 12 * 12);
  EXPECT_NEAR(dubins_length(pose(0, 0, 0), pose(40, 30, 0), 6),
              line + 12 * (std::atan2(28, 30) + std::atan2(12, line)), 1e-9);
}

TEST(Dubins, EqualPosesNeedNoWay) {
  const Pose here = pose(12.3, -4.5, 77);
  EXPECT_EQ(dubins_length(here, here, 6), 0);
  EXPECT_TRUE(shortest_dubins(here, here, 6).path.empty());
  EXPECT_EQ(reeds_shepp_length(here, here, 6), 0);
  EXPECT_TRUE(shortest_reeds_shepp(here, here, 6).path.empty());
  EXPECT_TRUE(reeds_shepp_words(here, here, 6).front().path.empty());
}

/// Along a line or round a circle no way is shorter than the lower bound; one metre aside, with the heading
/// turned about, half a circle has to be driven at least.
TEST(Words, LeastLengthIsThatOfALineOrACircle) {
  EXPECT_NEAR(least_length(pose(0, 0, 90), pose(25, 0, 90), 6), 25, 1e-12);
  const double quarter_m = 0.5 * std::numbers::pi * 6;
  EXPECT_NEAR(least_length(pose(0, 0, 0), pose(6, 6, 90), 6), quarter_m, 1e-9);
  EXPECT_NEAR(least_length(pose(0, 0, 0), pose(1, 0, 180), 6), 2 * quarter_m, 1e-9);
}

TEST(Dubins, RoundingAsksForNoLoop) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const Pose from = pose(3, 7, degrees);
    for (const double ahead : {1e-6, 0.1, 3.0, 1e3}) {
      const Pose to{from.at + ahead * from.heading.unit(), from.heading};
      EXPECT_NEAR(dubins_length(from, to, 6), ahead, 1e-8) << degrees;
      for (const Manoeuvre& word : dubins_words(from, to, 6)) expect_leads(word, from, to);
    }
  }
}

TEST(ReedsShepp, WaysKnownByHand) {
  const Manoeuvre back = shortest_reeds_shepp(pose(0, 0, 0), pose(0, -9, 0), 6);
  EXPECT_EQ(back.word, "s");
  EXPECT_NEAR(length(back.path), 9, 1e-9);
  EXPECT_EQ(gear_changes(back), 2);
  // about face on the spot: three arcs of 60 degrees
  const Manoeuvre about = shortest_reeds_shepp(pose(0, 0, 0), pose(0, 0, 180), 6);
  EXPECT_NEAR(length(about.path), 6 * kWordPi, 1e-9);
  EXPECT_EQ(about.path.size(), 3U);
  EXPECT_EQ(gear_changes(about.path), 2);
}

struct DrawnPoses {
  Pose from, to;
  double radius_m;
};

DrawnPoses drawn_poses(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double size = std::exp(between(-2, 4));
  return {pose(between(-size, size), between(-size, size), between(0, 360)),
          pose(between(-size, size), between(-size, size), between(0, 360)), std::exp(between(0, 3))};
}

TEST(Words, EveryOneLeadsToItsEnd) {
  std::mt19937_64 random(2);
  std::set<std::string> seen;
  for (int i = 0; i < 400; ++i) {
    const auto [from, to, radius_m] = drawn_poses(random);
    const auto dubins = dubins_words(from, to, radius_m), both = reeds_shepp_words(from, to, radius_m);
    ASSERT_FALSE(dubins.empty());
    ASSERT_FALSE(both.empty());
    EXPECT_NEAR(length(dubins.front().path), dubins_length(from, to, radius_m), 1e-9 * radius_m + 1e-7);
    EXPECT_NEAR(length(both.front().path), reeds_shepp_length(from, to, radius_m), 1e-9 * radius_m + 1e-7);
    EXPECT_LE(length(both.front().path), length(dubins.front().path) + 1e-7);
    for (const Manoeuvre& word : dubins) {
      EXPECT_EQ(gear_changes(word), 0);
      expect_leads(word, from, to);
      expect_no_tighter(word, radius_m);
      seen.insert(word.word);
    }
    for (const Manoeuvre& word : both) {
      expect_leads(word, from, to);
      expect_no_tighter(word, radius_m);
      seen.insert(word.word);
    }
  }
  for (const char* word : {"LSL", "RSR", "LSR", "RSL", "LRL", "RLR"}) EXPECT_TRUE(seen.count(word)) << word;
  const std::set<std::string> families = {
      "lsl",   "rsr",   "lsr",   "rsl",                                   // CSC
      "LrL",   "RlR",   "lRl",   "rLr",  "Lrl",  "Rlr",  "lRL",  "rLR",   // C|C|C, C|CC
      "lrL",   "rlR",   "LRl",   "RLr",                                   // CC|C
      "LRlr",  "RLrl",  "lrLR",  "rlRL", "LrlR", "RlrL", "lRLr", "rLRl",  // CC|CC, C|CC|C
      "Lrsl",  "Rlsr",  "lRSL",  "rLSR", "Lrsr", "Rlsl", "lRSR", "rLSL",  // C|CSC
      "LSRl",  "RSLr",  "lsrL",  "rslR", "LSLr", "RSRl", "lslR", "rsrL",  // CSC|C
      "LrslR", "RlsrL", "lRSLr", "rLSRl"};                                // C|CSC|C
  for (const std::string& word : families) EXPECT_TRUE(seen.count(word)) << word;
  EXPECT_EQ(families.size() + 4, 48U) << "with CSC forward";
}

Pose turned_about(const Pose& p) {
  return {p.at, Heading::clockwise_from_north(p.heading.angle() + Angle::degrees(180))};
}

Pose mirrored_pose(const Pose& p) {  // in the axis x = 0
  return {{-p.at.x, p.at.y}, Heading::clockwise_from_north(-p.heading.angle())};
}

TEST(Words, AreAsLongDrivenFromTheEndAndInTheMirror) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const auto [from, to, radius_m] = drawn_poses(random);
    const double dubins = dubins_length(from, to, radius_m), both = reeds_shepp_length(from, to, radius_m);
    const double tolerance = 1e-9 * (1 + dubins);
    EXPECT_NEAR(dubins_length(turned_about(to), turned_about(from), radius_m), dubins, tolerance);
    EXPECT_NEAR(dubins_length(mirrored_pose(from), mirrored_pose(to), radius_m), dubins, tolerance);
    EXPECT_NEAR(reeds_shepp_length(turned_about(to), turned_about(from), radius_m), both, tolerance);
    EXPECT_NEAR(reeds_shepp_length(mirrored_pose(from), mirrored_pose(to), radius_m), both, tolerance);
    EXPECT_NEAR(reeds_shepp_length(to, from, radius_m), both, tolerance);
    const Manoeuvre word = shortest_dubins(from, to, radius_m);
    const SteeredPath round = turned_round(word.path), image = mirrored(word.path, pose(0, 5, 0));
    expect_leads({word.kind, testing::spelled(round), round}, turned_about(to), turned_about(from));
    expect_leads({word.kind, testing::spelled(image), image}, mirrored_pose(from), mirrored_pose(to));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace tramline
