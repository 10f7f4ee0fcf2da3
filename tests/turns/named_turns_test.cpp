// U, omega, turns of unequal arcs, fishtail and the way back out: lengths and depths by hand.

#include <gtest/gtest.h>

#include "tramline/turns/manoeuvres/back_out.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/fishtail.h"
#include "tramline/turns/manoeuvres/omega_turn.h"
#include "tramline/turns/manoeuvres/reach.h"
#include "tramline/turns/manoeuvres/u_turn.h"
#include "tramline/turns/manoeuvres/unequal_arcs.h"
#include "turns/expect_manoeuvre.h"

namespace tramline {
namespace {

using testing::expect_leads;
using testing::pose;

constexpr double kTurnPi = std::numbers::pi;
const Pose kTrackEnd = testing::pose(100, 200, 0);

/// The start of the next track, driven southwards: s to the east, and ahead.
Pose next_start(double s, double ahead = 0) { return testing::pose(100 + s, 200 + ahead, 180); }

double depth(const Manoeuvre& manoeuvre) { return reach(manoeuvre.path, {0, 1}); }

TEST(UTurn, IsTwoQuarterTurnsAndALine) {
  for (const double r : {3.0, 6.0, 8.5})
    for (const double s : {2 * r, 2 * r + 0.01, 3 * r, 36.0})
      for (const double side : {1.0, -1.0}) {
        const auto turn = u_turn(kTrackEnd, next_start(side * s), r);
        ASSERT_TRUE(turn) << r << " " << s;
        EXPECT_EQ(turn->kind, ManoeuvreKind::kU);
        EXPECT_EQ(turn->word, s == 2 * r ? (side > 0 ? "R" : "L") : (side > 0 ? "RSR" : "LSL"));
        EXPECT_NEAR(length(turn->path), kTurnPi * r + s - 2 * r, 1e-9);
        EXPECT_NEAR(depth(*turn), r, 1e-9);
        expect_leads(*turn, kTrackEnd, next_start(side * s));
        EXPECT_NEAR(dubins_length(kTrackEnd, next_start(side * s), r), length(turn->path), 1e-9);
      }
}

TEST(UTurn, OfExactlyTwoRadiiIsOneHalfCircleInEveryDirection) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const Pose from = pose(-31.7, 1234.5, degrees);
    const Pose to = end_of(arc_from(from, 6.1 * kTurnPi, -1 / 6.1, Gear::kForward));
    const auto turn = u_turn(from, to, 6.1);
    ASSERT_TRUE(turn) << degrees;
    EXPECT_NEAR(length(turn->path), 6.1 * kTurnPi, 1e-9) << degrees;
    EXPECT_EQ(turn->word, "R");
  }
}

TEST(UTurn, IsNoneWhereTracksAreTooNearStaggeredOrGoOn) {
  EXPECT_FALSE(u_turn(kTrackEnd, next_start(11.9), 6));
  EXPECT_FALSE(u_turn(kTrackEnd, next_start(20, 1), 6));
  EXPECT_FALSE(u_turn(kTrackEnd, pose(100, 230, 0), 6));
  EXPECT_FALSE(u_turn(kTrackEnd, pose(130, 230, 30), 6));
}

TEST(UTurn, TurnsByEqualAnglesBetweenOtherHeadings) {
  // two turns of 60 degrees about (106, 200) and, 20 m farther in their direction, the second centre
  const Point centre = Point{106, 200} + 20 * Point{std::sin(kTurnPi / 3), std::cos(kTurnPi / 3)};
  const Pose to{centre + 6 * turned({-1, 0}, -2 * kTurnPi / 3),
                Heading::clockwise_from_north(Angle::degrees(120))};
  const auto turn = u_turn(kTrackEnd, to, 6);
  ASSERT_TRUE(turn);
  EXPECT_NEAR(length(turn->path), 6 * 2 * kTurnPi / 3 + 20, 1e-9);
  expect_leads(*turn, kTrackEnd, to);
}

TEST(OmegaTurn, HasTheLengthAndTheDepthOfItsThreeCircles) {
  for (const double r : {3.0, 6.0, 8.5})
    for (const double s : {0.0, 0.5 * r, r, 1.9 * r, -0.5 * r, -r}) {
      const auto turn = omega_turn(kTrackEnd, next_start(s), r);
      ASSERT_TRUE(turn) << r << " " << s;
      const double half = r + 0.5 * std::abs(s);
      EXPECT_EQ(turn->kind, ManoeuvreKind::kOmega);
      EXPECT_EQ(turn->word, s >= 0 ? "LRL" : "RLR");
      EXPECT_NEAR(length(turn->path), r * (kTurnPi + 4 * std::acos(half / (2 * r))), 1e-9);
      EXPECT_NEAR(depth(*turn), r + std::sqrt(4 * r * r - half * half), 1e-9);
      expect_leads(*turn, kTrackEnd, next_start(s));
      EXPECT_NEAR(dubins_length(kTrackEnd, next_start(s), r), length(turn->path), 1e-9);
    }
  EXPECT_FALSE(omega_turn(kTrackEnd, next_start(20), 6));
  EXPECT_FALSE(omega_turn(kTrackEnd, next_start(6, 2), 6));
}

TEST(UnequalArcs, MakeUpForTheStagger) {
  // centres at (106, 200) and (114, 204)
  const auto turn = unequal_arcs(kTrackEnd, next_start(20, 4), 6);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->kind, ManoeuvreKind::kUnequalArcs);
  EXPECT_EQ(turn->word, "RSR");
  EXPECT_NEAR(length(turn->path), 6 * kTurnPi + std::sqrt(80.0), 1e-9);
  expect_leads(*turn, kTrackEnd, next_start(20, 4));
  // the heading on the line is atan2(8, 4) from north, so the first arc is that
  EXPECT_NEAR(turn->path[0].length_m, 6 * std::atan2(8.0, 4.0), 1e-9);
  EXPECT_FALSE(unequal_arcs(kTrackEnd, next_start(20), 6));
}

TEST(UnequalArcs, OfThreeTurnsWhereTracksAreNear) {
  const auto turn = unequal_arcs(kTrackEnd, next_start(6, 3), 6);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->word, "LRL");
  // centres of the outer circles at (94, 200) and (112, 203); the middle one is 12 m from both
  const double apart = std::hypot(18, 3), bend = std::acos(apart / 24);
  EXPECT_NEAR(length(turn->path), 6 * (kTurnPi + 4 * bend), 1e-9);
  expect_leads(*turn, kTrackEnd, next_start(6, 3));
}

TEST(LeadAndTurn, GoesOnUntilTheEndsAreLevel) {
  const auto before = lead_and_turn(kTrackEnd, next_start(20, 4), 6);
  ASSERT_TRUE(before);
  EXPECT_EQ(before->kind, ManoeuvreKind::kUnequalArcs);
  EXPECT_EQ(before->word, "SRSR");
  EXPECT_NEAR(length(before->path), 4 + 6 * kTurnPi + 8, 1e-9);
  EXPECT_NEAR(depth(*before), 10, 1e-9);
  expect_leads(*before, kTrackEnd, next_start(20, 4));

  const auto after = lead_and_turn(kTrackEnd, next_start(6, -5), 6);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->word, "LRLS");
  EXPECT_NEAR(length(after->path), 5 + 6 * (kTurnPi + 4 * std::acos(9.0 / 12)), 1e-9);
  expect_leads(*after, kTrackEnd, next_start(6, -5));
  EXPECT_FALSE(lead_and_turn(kTrackEnd, next_start(20), 6));
}

TEST(LeadAndTurn, LevelsEndsOfOtherHeadings) {
  for (const double heading : {120.0, 150.0, 210.0, 260.0})
    for (const double x : {-30.0, 40.0}) {
      const Pose to = pose(100 + x, 210, heading);
      const auto turn = lead_and_turn(kTrackEnd, to, 6);
      if (turn) expect_leads(*turn, kTrackEnd, to);
      if ((x > 0) == (heading < 180)) {
        EXPECT_TRUE(turn) << heading << " " << x;
      }
    }
}

TEST(Fishtail, IsTwoQuarterTurnsAndAWayBack) {
  for (const double r : {3.0, 6.0})
    for (const double s : {0.0, 0.5 * r, r, 1.9 * r}) {
      const auto turn = fishtail(kTrackEnd, next_start(s), r);
      ASSERT_TRUE(turn) << r << " " << s;
      EXPECT_EQ(turn->kind, ManoeuvreKind::kFishtail);
      EXPECT_EQ(turn->word, s > 0 ? "RsR" : turn->word);
      EXPECT_NEAR(length(turn->path), kTurnPi * r + 2 * r - s, 1e-9);
      EXPECT_NEAR(depth(*turn), r, 1e-9);
      EXPECT_EQ(gear_changes(*turn), 2);
      expect_leads(*turn, kTrackEnd, next_start(s));
    }
  EXPECT_FALSE(fishtail(kTrackEnd, next_start(12), 6));
  // to the other side as well: then the way back is 2r + s
  const auto both = fishtails(kTrackEnd, next_start(4), arc_turns(6));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].word, "LsL");
  EXPECT_NEAR(length(both[1].path), 6 * kTurnPi + 12 + 4, 1e-9);
}

TEST(Fishtail, AlsoBetweenStaggeredEnds) {
  // centres at (106, 200) and (98, 203): the way back is between them
  const auto turn = fishtail(kTrackEnd, next_start(4, 3), 6);
  ASSERT_TRUE(turn);
  EXPECT_NEAR(length(turn->path), 6 * kTurnPi + std::hypot(8, 3), 1e-9);
  expect_leads(*turn, kTrackEnd, next_start(4, 3));
}

TEST(Fishtail, TakesTheTimeOfItsStopsToo) {
  Machine machine;
  machine.turning.turning_speed_mps = 2;
  machine.turning.reverse_speed_mps = 0.5;
  machine.turning.gear_change_s = 4;
  const auto turn = fishtail(kTrackEnd, next_start(8), 6);
  ASSERT_TRUE(turn);
  EXPECT_NEAR(seconds(*turn, machine), 6 * kTurnPi / 2 + 4 / 0.5 + 2 * 4, 1e-9);
}

TEST(BackOut, ReversesAlongTheTrackAndThenTurns) {
  const auto out = back_out(kTrackEnd, next_start(20), 6, 15);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->kind, ManoeuvreKind::kBackOut);
  EXPECT_EQ(out->word.substr(0, 1), "s");
  EXPECT_NEAR(length(out->path), 15 + dubins_length(pose(100, 185, 0), next_start(20), 6), 1e-9);
  EXPECT_EQ(gear_changes(*out), 2);
  expect_leads(*out, kTrackEnd, next_start(20));
}

}  // namespace
}  // namespace tramline
