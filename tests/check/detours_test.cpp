// Plans with detours: good ones hold, and each fault is found under the right name only.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "check/plans.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using namespace testing_plans;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The east-going piece with the detour on its left, after a change; with the figures that follow.
Plan changed(const std::function<void(TrackPiece&)>& change) {
  Plan plan = poles_plan();
  change(plan.pieces[4]);
  return settled(plan);
}
Detour bulge_by(const TrackPiece& piece, double away_m, double radius_m) {
  return bulge(piece, 50, away_m, radius_m, Passing::kLeft, {0});
}

TEST(Detours, HoldWithTheFiguresOfTheirArcs) {
  const Plan plan = poles_plan();
  expect_holds(plan);
  // Each bulge is four times an arc of θ with r·sin θ a quarter of its extent.
  const double away = away_from_pole(6, 1.5, 0), half = std::sqrt(24 * away - away * away);
  const double bulge_m = 4 * 6 * std::asin(half / 12);
  EXPECT_NEAR(plan.tally.track_length_m, 1000 + 2 * (bulge_m - 2 * half), 1e-9);
  EXPECT_NEAR(plan.tally.worked_m2, 3 * plan.tally.track_length_m, 1e-9);
  EXPECT_EQ(plan.tally.stops, 0);
  EXPECT_EQ(plan.tally.pieces, 10);
  // What the bulge works of the strip beyond is overlap, what it leaves of its own is uncovered.
  const Region swath{{band(centre_line(plan.pieces[4]), 3, 1e-8), {}}};
  const Region strip{{box(0, 12, 100, 15), {}}};
  EXPECT_NEAR(plan.tally.overlap_m2, 2 * area(difference(swath, strip)), 1e-3);
  EXPECT_NEAR(plan.tally.uncovered_m2, 2 * (area(difference(strip, swath)) - 0.25), 1e-3);
  EXPECT_GT(plan.tally.uncovered_m2, 10);
}

TEST(Detours, HoldWhereverTheyLie) {
  for (const double degrees : {1.0, 33.3, 89.99, 122.4, 271.0})
    for (const double clearance_m : {0.0, 0.7}) {
      const Plan plan = poles_plan(clearance_m);
      const Plan moved = settled(turned(plan, Angle::degrees(degrees), {-712.3, 455.1}));
      expect_holds(moved);
      EXPECT_NEAR(moved.tally.uncovered_m2, plan.tally.uncovered_m2, 1e-3);
      EXPECT_NEAR(moved.tally.track_length_m, plan.tally.track_length_m, 1e-8);
    }
}

TEST(Detours, HoldUnderEveryEndRuleAndWithinAHardBoundary) {
  Plan plan = poles_plan();
  plan.settings.boundary = EdgeKind::kHard;
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest}) {
    plan.settings.end_rule = rule;
    expect_holds(plan);
  }
}

TEST(Detours, HoldOnEitherSideInEitherHeading) {
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    Plan plan = poles_plan();
    const double away = away_from_pole(6, 1.5, 0);
    plan.pieces[4].detours = {bulge(plan.pieces[4], 50, away, 6, side, {0})};
    plan.pieces[7].detours = {bulge(plan.pieces[7], 70, away, 6, side, {1})};
    plan.encounters = {encounter_on(plan.pieces[4], {50, 13.5}, {0}, side),
                       encounter_on(plan.pieces[7], {30, 22.5}, {1}, side)};
    expect_holds(settled(plan));
  }
}

TEST(Detours, HoldWhereASwathTurnsAboutItsOwnEdge) {
  Plan plan = poles_plan();
  plan.machine.radius_m = 0;
  // Arcs of 88° and 176° about a pole that a wider turn could not pass as closely.
  plan.pieces[4].detours = {bulge(plan.pieces[4], 50, 2.9, 1.5, Passing::kLeft, {0})};
  plan.pieces[7].detours = {bulge(plan.pieces[7], 70, 2.9, 1.5, Passing::kRight, {1})};
  expect_holds(settled(plan));
  expect_holds(settled(turned(plan, Angle::degrees(47.3), {333.3, 10})));
}

TEST(Detours, HoldFromTheVeryStartToTheVeryEndOfAPiece) {
  Plan plan = poles_plan();
  TrackPiece& piece = plan.pieces[4];
  const double half = 50 - piece.detours[0].path.front().from.x;
  plan.machine.min_length_m = 0;
  piece.start.x = piece.detours[0].path.front().from.x;
  expect_holds(settled(plan));
  piece.end.x = piece.detours[0].path.back().to.x;
  plan = settled(plan);
  expect_holds(plan);
  EXPECT_NEAR(distance(plan.pieces[4].start, plan.pieces[4].end), 2 * half, 1e-9);
}

TEST(Detours, TwoInOnePiece) {
  const Plan plan = [] {
    Plan out = poles_plan();
    const Ring pole = box(79.75, 13.25, 80.25, 13.75);
    out.field.obstacles.push_back({{pole, {}}, ObstacleKind::kObstacle, "pole"});
    out.body[0].holes.push_back(reversed(pole));
    out.subfields[0].shape = out.body[0];
    const double away = away_from_pole(6, 1.5, 0);
    out.pieces[4].detours.push_back(bulge(out.pieces[4], 80, away, 6, Passing::kRight, {2}));
    out.encounters.push_back(encounter_on(out.pieces[4], {80, 13.5}, {2}, Passing::kRight));
    return settled(out);
  }();
  expect_holds(plan);
  Plan swapped = plan;
  std::swap(swapped.pieces[4].detours[0], swapped.pieces[4].detours[1]);
  EXPECT_EQ(found(swapped), Names{"pieces"});
}

TEST(Detours, PushedIntoAnObstacle) {
  const double away = away_from_pole(6, 1.5, 0);
  EXPECT_EQ(found(changed([&](TrackPiece& p) { p.detours = {bulge_by(p, away - 0.05, 6)}; })),
            Names{"clearance"});
  EXPECT_EQ(found(changed([&](TrackPiece& p) { p.detours = {bulge_by(p, away - 0.002, 6)}; })),
            Names{"clearance"});
  EXPECT_EQ(found(changed([&](TrackPiece& p) { p.detours = {bulge_by(p, away - 0.0005, 6)}; })), Names{});
}

TEST(Detours, NearerThanTheClearance) {
  Plan plan = poles_plan(0.5);
  plan.settings.clearance_m = 0.5005;
  EXPECT_EQ(found(plan), Names{});
  plan.settings.clearance_m = 0.52;
  EXPECT_EQ(found(plan), Names{"clearance"});
  // The neighbours' straight swaths are 1.25 m away from the poles.
  plan = poles_plan(1.2495);
  EXPECT_EQ(found(plan), Names{});
  plan = poles_plan(1.26);
  EXPECT_EQ(found(plan), Names{"clearance"});
}

/// Straight swaths that end before an obstacle keep the clearance there too.
TEST(Detours, EndsNearerThanTheClearance) {
  Plan plan = obstacle_plan();
  plan.settings.clearance_m = 0.2;
  for (TrackPiece& piece : plan.pieces)
    for (Point* end : {&piece.start, &piece.end}) {
      if (end->x == 40) end->x = 39.8;
      if (end->x == 60) end->x = 60.2;
    }
  plan.given_up = {{box(39.8, 9, 40, 15), {}}, {box(60, 9, 60.2, 15), {}}};
  plan.subfields[0].shape = difference(plan.body, plan.given_up)[0];
  // Above and below it nothing is left between the swaths and the obstacle's extent.
  EXPECT_EQ(found(settled(plan)), Names{});
  plan.given_up[0] = {box(39.85, 9, 40, 15), {}};
  for (TrackPiece& piece : plan.pieces)
    for (Point* end : {&piece.start, &piece.end})
      if (end->x == 39.8) end->x = 39.85;
  plan.subfields[0].shape = difference(plan.body, plan.given_up)[0];
  EXPECT_EQ(found(settled(plan)), Names{"clearance"});
}

TEST(Detours, OverAPassableAndOverLandGivenUp) {
  Plan plan = poles_plan();
  plan.given_up = {{box(49.9, 14, 50.1, 14.3), {}}};
  EXPECT_EQ(found(settled(plan)), (Names{"clearance", "subfields"}));
  plan.subfields[0].shape.holes.push_back(reversed(plan.given_up[0].outer));
  EXPECT_EQ(found(settled(plan)), Names{"clearance"});

  plan = poles_plan();
  const Ring ditch = box(49.9, 14, 50.1, 14.3);
  plan.field.obstacles.push_back({{ditch, {}}, ObstacleKind::kPassable, "ditch"});
  plan.body[0].holes.push_back(reversed(ditch));
  EXPECT_EQ(found(settled(plan)), Names{"clearance"});
}

/// Smaller than any grid of samples, thinner than any area that counts: found all the same.
TEST(Detours, OverTinyAndNeedleThinObstacles) {
  const auto with = [](const Ring& obstacle) {
    Plan plan = poles_plan();
    plan.field.obstacles.push_back({{obstacle, {}}, ObstacleKind::kObstacle, "peg"});
    plan.body[0].holes.push_back(reversed(obstacle));
    plan.subfields[0].shape = plan.body[0];
    plan.pieces[4].detours[0].obstacles = plan.encounters[0].obstacles = {0, 2};
    return found(settled(plan));
  };
  EXPECT_EQ(with(box(50, 14.5, 50.05, 14.55)), Names{"clearance"});
  EXPECT_EQ(with({{50, 14}, {50.0001, 14}, {50, 14.9}}), Names{"clearance"});
  EXPECT_EQ(with(box(50, 12.1, 50.05, 12.15)), Names{});
}

/// `by_deg` at either end of the first arc, which is flatter than its neighbours want it.
Path kinked(Path path, double by_deg) {
  PathSegment& arc = path.front();
  const double chord = distance(arc.from, arc.to);
  const double half = std::asin(0.5 * chord * arc.curvature) - by_deg * std::numbers::pi / 180;
  arc.curvature = 2 * std::sin(half) / chord;
  return path;
}

TEST(Detours, WithKinks) {
  const auto with = [](double by_deg) {
    return check::verify(
        changed([&](TrackPiece& p) { p.detours[0].path = kinked(p.detours[0].path, by_deg); }));
  };
  const check::Verdict verdict = with(3);
  EXPECT_EQ(rules(verdict), Names{"drivable"});
  ASSERT_EQ(verdict.violations.size(), 2u);
  EXPECT_NEAR(verdict.violations[0].amount, 3, 1e-6);
  EXPECT_EQ(rules(with(0.9)), Names{});
  // The other way the arc is tighter; and this is what a kink the size of a right angle does.
  EXPECT_EQ(rules(with(1.1)), Names{"drivable"});
  EXPECT_EQ(rules(with(90)), Names{"drivable"});
}

/// Leaving or rejoining the line at an angle, with no joint of arcs at fault.
TEST(Detours, ThatLeaveTheLineAtAnAngle) {
  EXPECT_EQ(found(changed([](TrackPiece& p) { p.detours[0].path.front().curvature = 0; })),
            Names{"drivable"});
  Plan plan = poles_plan();
  TrackPiece& piece = plan.pieces[4];
  Path& path = piece.detours[0].path;
  // The detour begins with a straight line to where its first arc led.
  path = {{{20, 13.5}, path[0].to, 0}, path[1], path[2]};
  EXPECT_EQ(found(settled(plan)), Names{"drivable"});
}

TEST(Detours, TooTight) {
  const auto with = [](double radius_m) {
    return found(changed(
        [&](TrackPiece& p) { p.detours = {bulge_by(p, away_from_pole(radius_m, 1.5, 0), radius_m)}; }));
  };
  EXPECT_EQ(with(5.4), Names{"drivable"});
  EXPECT_EQ(with(5.93), Names{"drivable"});
  EXPECT_EQ(with(5.95), Names{});
  EXPECT_EQ(with(9), Names{});
  // Tighter than half the width the swath folds over itself, whatever the machine can do.
  Plan plan = poles_plan();
  plan.machine.radius_m = 0;
  plan.pieces[4].detours = {bulge_by(plan.pieces[4], 2.5, 1.3)};
  EXPECT_TRUE(found(settled(plan)).contains("drivable"));
}

TEST(Detours, ATrackOutsideTheField) {
  Plan plan = poles_plan();
  plan.pieces[9].start.y = plan.pieces[9].end.y = 31.6;
  EXPECT_EQ(found(settled(plan)), Names{"ends"});
}

TEST(Detours, ThatLeaveTheField) {
  Plan plan = poles_plan();
  // Round nothing, over the northern edge.
  plan.encounters.push_back(encounter_on(plan.pieces[9], {50, 28.5}, {}, Passing::kRight));
  plan.pieces[9].detours = {bulge(plan.pieces[9], 50, 1.7, 6, Passing::kRight, {})};
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
  plan.pieces[9].detours = {bulge(plan.pieces[9], 50, 1.4995, 6, Passing::kRight, {})};
  EXPECT_EQ(found(settled(plan)), Names{});
  plan.settings.boundary = EdgeKind::kHard;
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
  plan.pieces[9].detours = {bulge(plan.pieces[9], 50, 0.0005, 6, Passing::kRight, {})};
  EXPECT_EQ(found(settled(plan)), Names{});
}

/// A notch of the field thinner than a chord of the detour is long.
TEST(Detours, ThatCrossANotch) {
  Plan plan = poles_plan();
  plan.field.outer = {{0, 0}, {100, 0}, {100, 30}, {50.01, 30}, {50.005, 29}, {50, 30}, {0, 30}};
  plan.body[0].outer = plan.field.outer;
  plan.subfields[0].shape = plan.body[0];
  plan.pieces[9].detours = {bulge(plan.pieces[9], 50, 1.4, 6, Passing::kRight, {})};
  plan.encounters.push_back(encounter_on(plan.pieces[9], {50, 28.5}, {}, Passing::kRight));
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
}

TEST(Detours, FalseFigures) {
  const auto with = [](auto change) {
    Plan plan = poles_plan();
    change(plan);
    return found(plan);
  };
  EXPECT_EQ(with([](Plan& p) { p.tally.overlap_m2 += 0.01; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.uncovered_m2 -= 0.01; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.track_length_m = 1000; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.uncovered.pop_back(); }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.overlap.pop_back(); }), Names{"tally"});
  // The bulge forgotten: straight through the pole, with the figures of the detour.
  EXPECT_EQ(with([](Plan& p) { p.pieces[4].detours.clear(); }), (Names{"swaths", "encounters", "tally"}));
}

TEST(Detours, ThatTellAnotherStory) {
  const auto with = [](auto change) {
    Plan plan = poles_plan();
    change(plan.pieces[4].detours[0], plan.encounters[0]);
    return found(plan);
  };
  EXPECT_EQ(with([](Detour& d, Encounter&) { d.side = Passing::kRight; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.chosen = Passing::kRight; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.chosen = Passing::kCut; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour& d, Encounter& e) { d.side = e.chosen = Passing::kRight; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour& d, Encounter&) { d.obstacles = {1}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.obstacles = {1}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour& d, Encounter& e) { d.obstacles = e.obstacles = {1}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour& d, Encounter& e) { d.obstacles = e.obstacles = {0, 1}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour& d, Encounter& e) { d.obstacles = e.obstacles = {}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.obstacles = {2}; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.track = 5; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.subfield = std::numeric_limits<std::size_t>::max(); }),
            Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.at.x = 60; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.at.y += 0.1; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.at.x = kNaN; }), Names{"encounters"});
  EXPECT_EQ(with([](Detour&, Encounter& e) { e.obstacles = {}; }), Names{"encounters"});
}

/// The other arm lies on the side of passing, 10 m from the line and out of the way.
TEST(Detours, IntoABayBetweenTheArmsOfAnObstacle) {
  const Plan plan = bay_plan();
  expect_holds(plan);
  expect_holds(settled(turned(plan, Angle::degrees(213.4), {-71, 1200})));

  Plan swapped = plan;
  swapped.pieces[5].detours[0].side = swapped.encounters.back().chosen = Passing::kRight;
  EXPECT_EQ(found(swapped), Names{"encounters"});
  // Mirrored in the line the bulge runs through the arm in the way, which is then on its left.
  Plan mirrored = plan;
  mirrored.pieces[5].detours = {bulge(plan.pieces[5], 45.25, 1.1, 6, Passing::kRight, {0})};
  mirrored.pieces[5].detours[0].side = Passing::kLeft;
  EXPECT_TRUE(found(settled(mirrored)).contains("encounters"));
}

/// Out of the way and on the side of passing only.
TEST(Detours, ThatNameAnObstacleTheyTurnTowards) {
  Plan plan = poles_plan();
  const Ring pole = box(49.75, 22.25, 50.25, 22.75);
  plan.field.obstacles[1].shape.outer = pole;
  plan.body[0].holes[1] = plan.subfields[0].shape.holes[1] = reversed(pole);
  plan.pieces[7].detours = {bulge(plan.pieces[7], 50, away_from_pole(6, 1.5, 0), 6, Passing::kRight, {1})};
  plan.encounters[1].at = {50, 22.5};
  plan = settled(plan);
  expect_holds(plan);
  plan.pieces[4].detours[0].obstacles = {0, 1};
  EXPECT_EQ(found(plan), Names{"encounters"});
}

/// Cuts said to be where there are none.
TEST(Detours, CutsThatAreNone) {
  const auto with = [](auto change) {
    Plan plan = poles_plan();
    plan.encounters.push_back(encounter_on(plan.pieces[2], {150, 7.5}, {}, Passing::kCut));
    change(plan.encounters.back());
    return found(plan);
  };
  // Beyond its track's end a cut takes nothing away; but it has to be somewhere.
  EXPECT_EQ(with([](Encounter&) {}), Names{});
  EXPECT_EQ(with([](Encounter& e) { e.at.x = 50; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.at.y = 7.6; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.at.x = kNaN; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.subfield = 7; }), Names{"encounters"});
}

/// A piece that bears the number of a track that is cut elsewhere.
TEST(Detours, CutsBesideAPieceOfTheirNumber) {
  Plan plan = obstacle_plan();
  plan.pieces[0].track = 3;
  EXPECT_EQ(found(plan), Names{"encounters"});
}

/// A plan has to own up to every place where an obstacle changes what is driven.
TEST(Detours, WhoseEncountersAreDeleted) {
  const auto without = [](std::size_t index) {
    Plan plan = poles_plan();
    plan.encounters.erase(plan.encounters.begin() + static_cast<long>(index));
    return check::verify(plan);
  };
  for (const std::size_t index : {0u, 1u}) {
    const check::Verdict verdict = without(index);
    EXPECT_EQ(rules(verdict), Names{"encounters"});
    EXPECT_EQ(verdict.violations.size(), 1u);
  }
  Plan plan = poles_plan();
  plan.encounters.clear();
  EXPECT_EQ(check::verify(plan).violations.size(), 2u);
}

/// One detour past two poles that lie in its way: both are named where they are met.
TEST(Detours, WhoseEncountersLeaveOutAnObstacle) {
  Plan plan = poles_plan();
  const Ring second = box(50.75, 13.25, 51, 13.75);
  plan.field.obstacles.push_back({{second, {}}, ObstacleKind::kObstacle, "second pole"});
  plan.body[0].holes.push_back(reversed(second));
  plan.subfields[0].shape = plan.body[0];
  plan.pieces[4].detours = {bulge(plan.pieces[4], 50.5, 2.1, 6, Passing::kLeft, {0, 2})};
  plan.encounters[0].obstacles = {0, 2};
  expect_holds(settled(plan));
  plan.encounters[0].obstacles = {0};
  EXPECT_EQ(found(settled(plan)), Names{"encounters"});
  // Or at one encounter each.
  plan.encounters.push_back(encounter_on(plan.pieces[4], {50.9, 13.5}, {2}, Passing::kLeft));
  expect_holds(settled(plan));
  plan.encounters.erase(plan.encounters.begin());
  EXPECT_EQ(found(settled(plan)), Names{"encounters"});
}

/// What each way would cost, and why one is not possible, are what the decision rests on.
TEST(Detours, DecidedAgainstTheirOwnFigures) {
  const auto with = [](auto change) {
    Plan plan = poles_plan();
    change(plan.encounters[0]);
    return found(plan);
  };
  const std::string why = "there is no room between the obstacles";
  EXPECT_EQ(with([](Encounter&) {}), Names{});
  EXPECT_EQ(with([&](Encounter& e) { e.right = {false, 0, why}; }), Names{});
  EXPECT_EQ(with([&](Encounter& e) { e.left = {false, 0, why}; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.right = {false, 0, ""}; }), Names{"encounters"});
  EXPECT_EQ(with([&](Encounter& e) { e.right.why_not = why; }), Names{"encounters"});
  EXPECT_EQ(with([&](Encounter& e) { e.left.why_not = why; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.right.cost = kNaN; }), Names{"encounters"});
  // On the left at −1: a cut costs 0.
  EXPECT_EQ(with([](Encounter& e) { e.right.cost = -1.001; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.right.cost = -1 - 1e-9; }), Names{});
  EXPECT_EQ(with([](Encounter& e) { e.left.cost = 0.001; }), Names{"encounters"});
  EXPECT_EQ(with([](Encounter& e) { e.left.cost = kNaN; }), Names{"encounters"});
}

TEST(Detours, ForgoneAgainstTheirOwnFigures) {
  Plan plan = obstacle_plan();
  plan.encounters[0].left = {true, 0.001, ""};
  EXPECT_EQ(found(plan), Names{});
  plan.encounters[0].left.cost = -0.001;
  EXPECT_EQ(found(plan), Names{"encounters"});
}

TEST(Detours, InAPlanThatCutsAllTracks) {
  Plan plan = poles_plan();
  plan.settings.avoid = Avoidance::kCut;
  EXPECT_EQ(found(plan), Names{"encounters"});
  plan.encounters.clear();
  EXPECT_EQ(found(plan), Names{"encounters"});
  // What a way would cost does not matter there.
  plan = obstacle_plan();
  plan.settings.avoid = Avoidance::kCut;
  plan.encounters[0].left = {true, -3, ""};
  EXPECT_EQ(found(plan), Names{});
}

/// Tracks 4 and 5 of the obstacle, 2 m wide across them, and the poles, 0.5 m wide.
TEST(Detours, AgainstTheRuleOfThePaper) {
  const auto with = [](Plan plan, auto change) {
    plan.settings.avoid = Avoidance::kPaper;
    for (Encounter& encounter : plan.encounters)
      for (WayPast* way : {&encounter.left, &encounter.right})
        if (way->cost > 0) *way = {false, 0, "the paper's rule passes on the other side"};
    change(plan);
    return found(plan);
  };
  const WayPast possible{true, 1, ""};
  EXPECT_EQ(with(poles_plan(), [](Plan&) {}), Names{});
  // It does not ask what a way costs.
  EXPECT_EQ(with(poles_plan(), [](Plan& p) { p.encounters[0].left.cost = 5; }), Names{});
  EXPECT_EQ(with(poles_plan(), [](Plan& p) { p.settings.avoid_threshold_m = 0.52; }), Names{});
  EXPECT_EQ(with(poles_plan(), [](Plan& p) { p.settings.avoid_threshold_m = 0.48; }), Names{"encounters"});
  EXPECT_EQ(with(poles_plan(), [&](Plan& p) { p.encounters[0].right = possible; }), Names{"encounters"});
  EXPECT_EQ(with(poles_plan(), [](Plan& p) { std::swap(p.encounters[0].left, p.encounters[0].right); }),
            Names{"encounters"});
  EXPECT_EQ(with(poles_plan(),
                 [](Plan& p) {
                   p.encounters.push_back(p.encounters[0]);
                   p.encounters.back().at.x += 1;
                 }),
            Names{"encounters"});
  EXPECT_EQ(with(obstacle_plan(), [](Plan&) {}), Names{});
  EXPECT_EQ(with(obstacle_plan(), [&](Plan& p) { p.encounters[0].left = possible; }), Names{"encounters"});
  // Another detour of the track may have been in its way.
  EXPECT_EQ(with(poles_plan(),
                 [&](Plan& p) {
                   p.encounters.push_back(encounter_on(p.pieces[4], {150, 13.5}, {}, Passing::kCut));
                   p.encounters.back().right = possible;
                 }),
            Names{});
}

TEST(Detours, Unsound) {
  const auto with = [](auto change) {
    Plan plan = poles_plan();
    change(plan.pieces[4].detours[0]);
    const check::Verdict verdict = check::verify(plan);
    EXPECT_FALSE(verdict.complete);
    return rules(verdict);
  };
  EXPECT_EQ(with([](Detour& d) { d.path.clear(); }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.side = Passing::kCut; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.obstacles = {2}; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.obstacles = {std::numeric_limits<std::size_t>::max()}; }),
            Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].to.x = kNaN; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].from.x = 1e12; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].curvature = kNaN; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].curvature = 1e-300; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].curvature = 1; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path[1].from.x += 1e-5; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) {
              d.path.insert(d.path.begin(), {d.path[0].from, d.path[0].from, 0});
            }),
            Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path.front().from.y += 0.002; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path.back().to.y += 0.002; }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path = reversed(d.path); }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) { d.path.push_back({d.path.back().to, {101, 13.5}, 0}); }), Names{"pieces"});
  EXPECT_EQ(with([](Detour& d) {
              d.path.insert(d.path.begin(), {{-1, 13.5}, d.path.front().from, 0});
            }),
            Names{"pieces"});
  Plan plan = poles_plan();
  plan.settings.clearance_m = kNaN;
  EXPECT_EQ(found(plan), Names{"pieces"});
  plan = poles_plan();
  plan.machine.radius_m = -1;
  EXPECT_EQ(found(plan), Names{"pieces"});
}

/// 40 tracks, 120 poles and as many detours.
TEST(Detours, ByTheHundredAreJudged) {
  Plan plan;
  plan.field.outer = box(0, 0, 180, 120);
  plan.machine.width_m = 3;
  plan.body = {{plan.field.outer, {}}};
  const double away = away_from_pole(6, 1.5, 0);
  for (int i = 0; i < 40; ++i) {
    const double y = 3 * i + 1.5;
    TrackPiece piece{{0, y}, {180, y}, 0, i};
    for (int k = 0; k < 3; ++k) {
      const double x = 30 + 60 * k + (i % 2) * 20;
      const Ring pole = box(x - kPoleHalf_m, y - kPoleHalf_m, x + kPoleHalf_m, y + kPoleHalf_m);
      const std::size_t number = plan.field.obstacles.size();
      plan.field.obstacles.push_back({{pole, {}}, ObstacleKind::kObstacle, "pole"});
      plan.body[0].holes.push_back(reversed(pole));
      piece.detours.push_back(bulge(piece, x, away, 6, i < 39 ? Passing::kLeft : Passing::kRight, {number}));
      plan.encounters.push_back(encounter_on(piece, {x, y}, {number}, piece.detours.back().side));
    }
    plan.pieces.push_back(piece);
  }
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  plan = settled(plan);
  expect_holds(plan);
}

}  // namespace
}  // namespace tramline
