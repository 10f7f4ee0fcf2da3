// Turns with clothoids: what the wheels do, the ends, and the way to turns without.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/fishtail.h"
#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/manoeuvres/omega_turn.h"
#include "tramline/turns/manoeuvres/reach.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "tramline/turns/manoeuvres/three_turns.h"
#include "tramline/turns/manoeuvres/u_turn.h"
#include "tramline/turns/manoeuvres/unequal_arcs.h"
#include "turns/expect_manoeuvre.h"

namespace tramline {
namespace {

using testing::expect_leads;
using testing::expect_no_tighter;
using testing::expect_steerable;
using testing::pose;

constexpr double kClothoidPi = std::numbers::pi;
const Pose kLastPose = testing::pose(100, 200, 0);
Pose next_pose(double s, double ahead = 0) { return testing::pose(100 + s, 200 + ahead, 180); }

Machine steered_machine(double steering_time_s) {
  Machine machine;
  machine.turning.reverse = true;
  machine.turning.steering_time_s = steering_time_s;
  return machine;
}

TEST(TurnCurve, TheClothoidTakesTheTimeOfTheWheels) {
  // 1.5 m/s and 1 m/s for 2 s: 3 m and 2 m to a radius of 6 m
  const TurnCurves curves = turn_curves(steered_machine(2));
  EXPECT_NEAR(curves.forward.clothoid_m, 3, 1e-12);
  EXPECT_NEAR(curves.reverse.clothoid_m, 2, 1e-12);
  // a clothoid of 3 m to 6 m deflects by a quarter, and its end is, by the series of Fresnel's integrals,
  // 3 (1 − θ²/10 + θ⁴/216) ahead and 3 (θ/3 − θ³/42 + θ⁵/1320) to the side
  const double theta = 0.25, ahead = 3 * (1 - theta * theta / 10 + std::pow(theta, 4) / 216),
               aside = 3 * (theta / 3 - std::pow(theta, 3) / 42 + std::pow(theta, 5) / 1320);
  EXPECT_NEAR(curves.forward.ahead_m, ahead - 6 * std::sin(theta), 1e-6);
  EXPECT_NEAR(curves.forward.aside_m, aside + 6 * std::cos(theta), 1e-6);
  EXPECT_NEAR(curves.forward.full_deflection_rad, 0.5, 1e-12);
}

TEST(TurnCurve, EveryDeflectionEndsOnTheSameCircle) {
  const TurnCurve curve = turn_curve(6, 1 / (6 * 4.5));
  for (const Gear gear : {Gear::kForward, Gear::kReverse})
    for (const double deflection : {1e-7, 0.01, 0.3, 0.749, 0.75, 0.8, 2.0, 4.0, 6.2}) {
      const auto turn = turn_from(kLastPose, deflection, TurnSide::kLeft, gear, curve);
      ASSERT_TRUE(turn) << deflection;
      const double sense = gear == Gear::kForward ? 1 : -1;
      const auto end = testing::driven(kLastPose, *turn, 4000).back();
      const Point u{std::cos(end.angle), std::sin(end.angle)};
      const Point at{end.x, end.y};
      const Point centre = kLastPose.at + Point{-curve.aside_m, sense * curve.ahead_m};
      const Point from_end = at - sense * curve.ahead_m * u + curve.aside_m * left_of(u);
      EXPECT_LE(distance(centre, from_end), 1e-9) << deflection;
      EXPECT_NEAR(end.angle - 0.5 * kClothoidPi, sense * deflection, 1e-9);
      for (const SteeredStretch& stretch : *turn) {
        EXPECT_LE(std::abs(stretch.curvature_at_end), (1 + 1e-9) / 6);
        EXPECT_LE(std::abs(stretch.curvature_at_end - stretch.curvature_at_start),
                  curve.sharpness * stretch.length_m * (1 + 1e-8));
      }
    }
}

TEST(ClothoidTurns, TheWheelsTurnNoFasterThanTheyCan) {
  std::mt19937_64 random(4);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int without = 0;
  std::set<std::string> seen;
  for (int i = 0; i < 150; ++i) {
    Machine machine = steered_machine(i % 5 == 0 ? between(5, 40) : between(0.2, 4));
    machine.radius_m = between(3, 10);
    const double size = std::exp(between(0, 4));
    const Pose from = pose(between(-size, size), between(-size, size), between(0, 360));
    const Pose to = pose(between(-size, size), between(-size, size), between(0, 360));
    const double sharp = 1 / (machine.radius_m * machine.turning.steering_time_s);
    const auto all = manoeuvres_between(from, to, machine);
    without += all.empty() ? 1 : 0;
    if (i % 5 != 0) {
      EXPECT_FALSE(all.empty()) << i;
    }
    for (const Manoeuvre& manoeuvre : all) {
      seen.insert(manoeuvre.word);
      expect_leads(manoeuvre, from, to);
      expect_no_tighter(manoeuvre, machine.radius_m);
      expect_steerable(manoeuvre, sharp / machine.turning.turning_speed_mps,
                       sharp / machine.turning.reverse_speed_mps);
      if (HasFailure()) FAIL() << i;
    }
  }
  EXPECT_EQ(without, 0);
  for (const char* word :
       {"LSL", "RSR", "LSR", "RSL", "LRL", "RLR", "lsl", "LrL", "rLr", "lrL", "Lrl", "RsR"})
    EXPECT_TRUE(seen.count(word)) << word;
}

TEST(ClothoidTurns, WithoutDeflectionTheyAreALine) {
  const TurnCurve curve = turn_curves(steered_machine(2)).forward;
  for (const double ahead : {0.2, 1.0, 5.0, 60.0}) {
    const auto words = dubins_words(kLastPose, pose(100, 200 + ahead, 0), curve);
    ASSERT_FALSE(words.empty()) << ahead;
    EXPECT_EQ(words.front().word, "S");
    EXPECT_NEAR(length(words.front().path), ahead, 1e-9);
  }
  EXPECT_TRUE(dubins_words(kLastPose, kLastPose, curve).front().path.empty());
}

/// The pose after turns and lines from a pose: a letter and an amount for each.
Pose led(Pose at, const std::vector<std::pair<char, double>>& parts, const TurnCurve& curve) {
  for (const auto& [letter, amount] : parts)
    at = letter == 'S' ? end_of(arc_from(at, amount, 0, Gear::kForward))
                       : end_of(turn_from(at, amount, letter == 'L' ? TurnSide::kLeft : TurnSide::kRight,
                                          Gear::kForward, curve)
                                    ->back());
  return at;
}

TEST(ClothoidTurns, WordsOfWhichATurnIsMissing) {
  const TurnCurve curve = turn_curves(steered_machine(2)).forward;
  const double line = 2 * curve.ahead_m;
  const std::vector<std::vector<std::pair<char, double>>> words = {{{'S', 7}, {'R', 1}},
                                                                   {{'L', 0.2}, {'S', 3}},
                                                                   {{'R', 2}},
                                                                   {{'S', 0.1}, {'L', 3}},
                                                                   {{'S', line}, {'R', 4}, {'L', 1}},
                                                                   {{'L', 1}, {'R', 4}, {'S', line}}};
  for (const auto& parts : words) {
    const Pose to = led(kLastPose, parts, curve);
    std::string expected;
    for (const auto& part : parts) expected += part.first;
    const auto found = dubins_words(kLastPose, to, curve);
    for (const Manoeuvre& word : found) expect_leads(word, kLastPose, to);
    EXPECT_EQ(
        std::count_if(found.begin(), found.end(), [&](const Manoeuvre& m) { return m.word == expected; }), 1)
        << expected;
  }
}

TEST(ClothoidTurns, LengthsFallToThoseOfArcsAsTheWheelsGetQuicker) {
  const auto length_of = [](const std::optional<Manoeuvre>& manoeuvre) {
    EXPECT_TRUE(manoeuvre);
    return manoeuvre ? length(manoeuvre->path) : 0;
  };
  const std::array<double, 6> times = {3, 1, 0.3, 0.1, 1e-2, 1e-4};
  double u = 1e9, omega = 1e9, fish = 1e9, lead = 1e9, shortest = 1e9;
  for (const double time : times) {
    const TurnCurves curves = turn_curves(steered_machine(time));
    const TurnCurve& curve = curves.forward;
    const auto falls = [&](double& before, double now) {
      EXPECT_LT(now, before) << time;
      before = now;
    };
    falls(u, length_of(u_turn(kLastPose, next_pose(24), curve)));
    falls(omega, length_of(omega_turn(kLastPose, next_pose(6), curve)));
    falls(fish, length_of(fishtail(kLastPose, next_pose(6), curves)));
    falls(lead, length_of(lead_and_turn(kLastPose, next_pose(24, 4), curve)));
    falls(shortest, length(dubins_words(kLastPose, pose(140, 230, 200), curve).front().path));
  }
  EXPECT_NEAR(u, length(u_turn(kLastPose, next_pose(24), 6)->path), 1e-3);
  EXPECT_NEAR(omega, length(omega_turn(kLastPose, next_pose(6), 6)->path), 1e-3);
  EXPECT_NEAR(fish, length(fishtail(kLastPose, next_pose(6), 6)->path), 1e-3);
  EXPECT_NEAR(lead, length(lead_and_turn(kLastPose, next_pose(24, 4), 6)->path), 1e-3);
  EXPECT_NEAR(shortest, dubins_length(kLastPose, pose(140, 230, 200), 6), 1e-3);
}

TEST(ClothoidTurns, BetweenOneTurnAndTwoTheArcIsWider) {
  const TurnCurve curve = turn_curves(steered_machine(2)).forward;
  const double one = 2 * curve.aside_m, two = one + 2 * curve.ahead_m;
  EXPECT_FALSE(u_turn(kLastPose, next_pose(one - 1e-6), curve));
  for (int i = 0; i <= 10; ++i) {
    const double s = one + (two - one) * i / 10;
    for (const double side : {1.0, -1.0}) {
      const auto turn = u_turn(kLastPose, next_pose(side * s), curve);
      ASSERT_TRUE(turn) << s;
      EXPECT_EQ(turn->kind, ManoeuvreKind::kU);
      const auto all = manoeuvres_between(kLastPose, next_pose(side * s), steered_machine(2));
      EXPECT_EQ(std::count_if(all.begin(), all.end(),
                              [](const Manoeuvre& m) { return m.kind == ManoeuvreKind::kU; }),
                1)
          << s;
      expect_leads(*turn, kLastPose, next_pose(side * s));
      expect_no_tighter(*turn, 6);
      expect_steerable(*turn, curve.sharpness, curve.sharpness);
      // not more than a fifth beyond the half circle that would do without steering
      EXPECT_LT(length(turn->path), 1.2 * (0.5 * kClothoidPi * s + 2 * curve.ahead_m));
    }
  }
}

TEST(ClothoidTurns, AFishtailStandsWithItsWheelsStraight) {
  const TurnCurves curves = turn_curves(steered_machine(2));
  for (const double s : {0.0, 5.0, 12.0, 12.4}) {
    const auto turn = fishtail(kLastPose, next_pose(s), curves);
    ASSERT_TRUE(turn) << s;
    expect_leads(*turn, kLastPose, next_pose(s));
    for (const SteeredStretch& stretch : turn->path)
      if (stretch.gear == Gear::kReverse) {
        EXPECT_EQ(stretch.curvature_at_start, 0);
        EXPECT_NEAR(stretch.length_m, 2 * (curves.forward.ahead_m + curves.forward.aside_m) - s, 1e-9);
      }
  }
}

TEST(ThreeTurns, OfArcsAreThoseOfReedsAndShepp) {
  std::mt19937_64 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose from = pose(0, 0, between(0, 360)),
               to = pose(between(-15, 15), between(-15, 15), between(0, 360));
    const auto turns = three_turns(from, to, arc_turns(6));
    for (const Manoeuvre& word : turns) {
      expect_leads(word, from, to);
      for (const SteeredStretch& stretch : word.path) EXPECT_LE(stretch.length_m, 6 * kClothoidPi + 1e-5);
    }
    const Manoeuvre shortest = shortest_reeds_shepp(from, to, 6);
    if (shortest.word.size() != 3 || shortest.word.find_first_of("sS") != std::string::npos) continue;
    ASSERT_FALSE(turns.empty());
    EXPECT_EQ(turns.front().word, shortest.word);
    EXPECT_NEAR(length(turns.front().path), length(shortest.path), 1e-7);
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace tramline
