// Plans with headlands: known by hand where they hold, and found out where they do not.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "check/plans.h"
#include "tramline/check/measure/near_land.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using namespace testing_plans;

/// Between a right angle and a rounding of 1 m.
const double kCornerShare = 1 - std::numbers::pi / 4;

Ring shifted(Ring ring, Point by) {
  for (Point& p : ring) p = p + by;
  return ring;
}

Path shifted(const Path& path, Point by) {
  return moved(path, [by](Point p) { return p + by; });
}

/// The outermost pass leaves the field's corners, the next one those between the two; the last one's inner
/// edge takes something of the body's corners.
TEST(Headlands, PassesWithRoundedCorners) {
  const Plan one = headland_plan(1), two = headland_plan(2);
  expect_holds(one);
  expect_holds(two);
  EXPECT_NEAR(one.headland.uncovered_m2, 4 * kCornerShare * 4.5 * 4.5, 1e-3);
  EXPECT_NEAR(one.headland.overlap_m2, 4 * kCornerShare * 1.5 * 1.5, 1e-3);
  EXPECT_NEAR(two.headland.uncovered_m2, 4 * kCornerShare * (2 * 4.5 * 4.5 - 1.5 * 1.5), 1e-3);
  EXPECT_NEAR(two.headland.overlap_m2, 4 * kCornerShare * 1.5 * 1.5, 1e-3);
  EXPECT_NEAR(two.track_tally.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(two.track_tally.uncovered_m2, 0, 1e-6);
}

/// What passes and tracks leave of body and headland counts once, and so do the figures of both together:
/// none of the passes' corners lies in the body, whose corners they work a second time.
TEST(Headlands, FiguresAreThoseOfTracksAndPasses) {
  const Plan plan = headland_plan(1);
  EXPECT_NEAR(plan.tally.uncovered_m2, 4 * kCornerShare * 4.5 * 4.5, 1e-3);
  EXPECT_NEAR(plan.tally.overlap_m2, 4 * kCornerShare * 1.5 * 1.5, 1e-3);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 0, 1e-6);
}

/// The figures of the tracks alone are not those of the plan.
TEST(Headlands, FiguresThatLeaveTheHeadlandOut) {
  Plan plan = headland_plan(1);
  plan.tally.uncovered_m2 = plan.track_tally.uncovered_m2;
  plan.tally.overlap_m2 = plan.track_tally.overlap_m2;
  plan.cost = cost(plan.objective, plan.tally);
  EXPECT_TRUE(found(plan).contains("tally"));
}

TEST(Headlands, LayersThatLeaveTheHeadlandOut) {
  Plan plan = headland_plan(1);
  plan.uncovered.clear();
  EXPECT_TRUE(found(plan).contains("tally"));
}

/// Files of earlier versions speak of tracks alone; they are held to that.
TEST(Headlands, FiguresOfTracksInOlderFiles) {
  Plan plan = headland_plan(1);
  plan.figures = PlanFigures::kTracks;
  plan.tally = plan.track_tally;
  plan.cost = cost(plan.objective, plan.tally);
  plan.overlap.clear();
  plan.uncovered.clear();
  expect_holds(plan);
}

TEST(Headlands, WorkIsInterruptedOnPassables) {
  Plan plan = headland_and_ditch_plan();
  expect_holds(plan);
  EXPECT_NEAR(plan.headland.worked_m2, headland_plan(2).headland.worked_m2 - 4 * 3 * 3, 1e-6);
  // Whether the subfield goes on along the ditch through the headland or not.
  plan.subfields[0].shape.outer = {{6, 6},   {40, 6},  {40, 0},  {43, 0},  {43, 6},  {94, 6},
                                   {94, 54}, {43, 54}, {43, 60}, {40, 60}, {40, 54}, {6, 54}};
  expect_holds(settled(plan));
}

/// The pass swings wide: round the corners it leaves more of the ground, at its outer edge it works the body.
TEST(Headlands, RoundAnObstacle) {
  const Plan plan = island_plan();
  expect_holds(plan);
  EXPECT_EQ(plan.tally.stops, 0);
  EXPECT_GT(plan.headland.overlap_m2, 1);
  EXPECT_GT(plan.headland.uncovered_m2, 1);
  // Two tracks that run on beside a quarter of a circle, at both ends.
  EXPECT_NEAR(plan.track_tally.overlap_m2, 4 * (std::numbers::pi / 4) * 9, 1e-2);
}

TEST(Headlands, TurningAndMovingChangesNothing) {
  for (const double degrees : {1.0, 33.3, 122.4})
    for (const Plan& plan : {headland_plan(2), island_plan(), headland_and_ditch_plan()}) {
      const Plan other = turned(plan, Angle::degrees(degrees), {-712.3, 455.1});
      expect_holds(settled(other));
    }
}

TEST(Headlands, PassOutOfTheFieldOrIntoAnObstacle) {
  Plan plan = headland_plan(2);
  plan.headland.passes[0].path = shifted(plan.headland.passes[0].path, {0, -0.05});
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});

  plan = headland_plan(2);
  plan.headland.passes[0].path = shifted(plan.headland.passes[0].path, {0, -200});
  EXPECT_EQ(found(settled(plan)), (Names{"headland", "swaths"})) << "nobody asked for it there";

  plan = island_plan();
  plan.headland.passes[0].path = shifted(plan.headland.passes[0].path, {0.05, 0.05});
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
}

TEST(Headlands, PassNearerToItsBoundaryThanItsNumberSays) {
  Plan plan = headland_plan(2);
  plan.headland.passes[1].path = shifted(plan.headland.passes[1].path, {0, -0.05});
  EXPECT_EQ(found(settled(plan)), Names{"headland"});
  // Half a millimetre nobody sees.
  plan = headland_plan(2);
  plan.headland.passes[1].path = shifted(plan.headland.passes[1].path, {0, -0.0005});
  EXPECT_EQ(found(settled(plan)), Names{});
  // Nor is it driven as the second one what is driven as the first.
  plan = headland_plan(2);
  plan.headland.passes[0].number = 2;
  EXPECT_EQ(found(settled(plan)), Names{"headland"});
}

TEST(Headlands, SecondPassRoundAnObstacleNearerThanItMay) {
  Plan plan = island_plan();
  plan.settings.obstacle_headlands = 2;
  plan.headland.obstacle_passes = {2};
  plan.headland.passes.push_back(plan.headland.passes[0]);
  plan.headland.passes[1].number = 2;
  Names names = found(settled(plan));
  EXPECT_TRUE(names.contains("headland"));
  plan.headland.passes[1].path = reversed(rounded_rectangle(35.5, 22.5, 64.5, 37.5, 4.5));
  names = found(settled(plan));
  EXPECT_FALSE(names.contains("headland"));
}

/// Its pass touches the copse.
TEST(Headlands, PassNearerToAnObstacleThanTheClearance) {
  Plan plan = island_plan();
  plan.settings.clearance_m = 0.0005;
  EXPECT_FALSE(found(settled(plan)).contains("headland"));
  plan.settings.clearance_m = 0.01;
  EXPECT_TRUE(found(settled(plan)).contains("headland"));
}

TEST(Headlands, PassThatCannotBeDriven) {
  const auto with = [](const Path& path) {
    Plan plan = headland_plan(1);
    plan.headland.passes[0].path = path;
    return found(settled(plan));
  };
  EXPECT_EQ(with(rounded_rectangle(1.5, 1.5, 98.5, 58.5, 3.5)), Names{});
  EXPECT_EQ(with(rounded_rectangle(1.5, 1.5, 98.5, 58.5, 2.9)), Names{"drivable"});
  EXPECT_EQ(with(rounded_rectangle(1.5, 1.5, 98.5, 58.5, 0)), Names{"drivable"});
  // One kink, where the path closes.
  Path kinked = rounded_rectangle(1.5, 1.5, 98.5, 58.5, kCorner_m);
  kinked.pop_back();
  kinked.back().to = {1.5, 1.5};
  kinked.front().from = {1.5, 1.5};
  EXPECT_EQ(with(kinked), Names{"drivable"});
}

/// A pass that leaves the south side at x = 30 for a detour and comes back to it heading east.
Path with_detour(const Path& detour) {
  const Path round = rounded_rectangle(1.5, 1.5, 98.5, 58.5, kCorner_m);
  Path out{{round.front().from, {30, 1.5}, 0}};
  out.insert(out.end(), detour.begin(), detour.end());
  out.push_back({detour.back().to, round.front().to, 0});
  out.insert(out.end(), round.begin() + 1, round.end());
  return out;
}

constexpr double kLeft = 1 / kCorner_m, kRight = -kLeft;

// Up at x = 33, a loop to the left, over its own track at (33, 23), and down.
TEST(Headlands, PassThatCrossesItself) {
  Plan plan = headland_plan(1);
  plan.headland.passes[0].path = with_detour({{{30, 1.5}, {33, 4.5}, kLeft},
                                              {{33, 4.5}, {33, 26}, 0},
                                              {{33, 26}, {30, 29}, kLeft},
                                              {{30, 29}, {27, 26}, kLeft},
                                              {{27, 26}, {30, 23}, kLeft},
                                              {{30, 23}, {36, 23}, 0},
                                              {{36, 23}, {39, 20}, kRight},
                                              {{39, 20}, {39, 4.5}, 0},
                                              {{39, 4.5}, {42, 1.5}, kLeft}});
  plan = settled(plan);
  const check::Verdict verdict = check::verify(plan);
  ASSERT_EQ(rules(verdict), Names{"headland"});
  EXPECT_NE(verdict.violations.front().what.find("headland pass 1 crosses itself"), std::string::npos);
  EXPECT_NEAR(distance(verdict.violations.front().at, {33, 23}), 0, 1e-6);
  EXPECT_EQ(found(settled(turned(plan, Angle::degrees(33.3), {-712.3, 455.1}))), Names{"headland"});
}

// Up at x = 33 with a bulge to the right, down at x = 45 with one to the left: they touch at (39, 16).
TEST(Headlands, PassThatTouchesItself) {
  Plan plan = headland_plan(1);
  plan.headland.passes[0].path = with_detour({{{30, 1.5}, {33, 4.5}, kLeft},
                                              {{33, 4.5}, {33, 10}, 0},
                                              {{33, 10}, {36, 13}, kRight},
                                              {{36, 13}, {39, 16}, kLeft},
                                              {{39, 16}, {36, 19}, kLeft},
                                              {{36, 19}, {33, 22}, kRight},
                                              {{33, 22}, {33, 26}, 0},
                                              {{33, 26}, {36, 29}, kRight},
                                              {{36, 29}, {42, 29}, 0},
                                              {{42, 29}, {45, 26}, kRight},
                                              {{45, 26}, {45, 22}, 0},
                                              {{45, 22}, {42, 19}, kRight},
                                              {{42, 19}, {39, 16}, kLeft},
                                              {{39, 16}, {42, 13}, kLeft},
                                              {{42, 13}, {45, 10}, kRight},
                                              {{45, 10}, {45, 4.5}, 0},
                                              {{45, 4.5}, {48, 1.5}, kLeft}});
  EXPECT_EQ(found(settled(plan)), Names{});
}

/// A field of 100 m by 60 m without headland, a copse 2 m from two of its edges with one pass of 3 m, and the
/// path given as that pass. No tracks.
Plan corner_plan(const Path& path, bool around_field) {
  Plan plan;
  plan.field.id = "corner";
  plan.field.outer = box(0, 0, 100, 60);
  plan.field.obstacles = {{{box(2, 2, 10, 7), {}}, ObstacleKind::kObstacle, "copse"}};
  plan.machine.width_m = 3;
  plan.machine.radius_m = kCorner_m;
  plan.settings.obstacle_headlands = 1;
  Ring edge = chords(rounded_rectangle(-1, -1, 13, 10, 3), 1e-4);
  edge.pop_back();
  const Region land = difference({{plan.field.outer, {}}}, {plan.field.obstacles[0].shape});
  plan.headland.ground = intersection(land, {{edge, {}}});
  plan.headland.obstacle_passes = {1};
  plan.headland.passes = {{path, 1, around_field, {0}}};
  plan.body = difference(land, plan.headland.ground);
  plan.subfields = {{plan.body[0], Direction::along({0, 0}, {1, 0})}};
  return settled(plan);
}

constexpr double kWideLeft = 1 / 4.5, kWideRight = -kWideLeft;

/// Along the copse's two free sides from edge to edge: 1.5 m and more off it, round its corner about (9, 6).
const Path kFreeSides{
    {{0, 10.5}, {9, 10.5}, 0}, {{9, 10.5}, {13.5, 6}, kWideRight}, {{13.5, 6}, {13.5, 0}, 0}};

TEST(Headlands, OpenPassAlongTheFreeSideOfAnObstacle) {
  const Names about_passes{"headland", "swaths", "drivable", "shapes"};
  const auto faults = [&](const Path& path) {
    Names out;
    for (const std::string& name : found(corner_plan(path, false)))
      if (about_passes.contains(name)) out.insert(name);
    return out;
  };
  EXPECT_EQ(faults(kFreeSides), Names{});
  EXPECT_EQ(faults(reversed(kFreeSides)), Names{});
  // Flat ends: 5 cm beyond the edge, and a corner of an oblique end.
  Path path = kFreeSides;
  path.front().from.x = -0.05;
  EXPECT_EQ(faults(path), Names{"swaths"});
  path = kFreeSides;
  path.back().to = {15, 0};
  EXPECT_TRUE(faults(path).contains("swaths"));
  path = kFreeSides;
  path.back().to.y = -0.05;
  EXPECT_EQ(faults(path), Names{"swaths"});
  // A kink between its parts, and into the obstacle.
  EXPECT_EQ(faults({{{0, 10.5}, {13.5, 10.5}, 0}, {{13.5, 10.5}, {13.5, 0}, 0}}), Names{"drivable"});
  EXPECT_EQ(faults(shifted(Path{{{5, 10.5}, {9, 10.5}, 0}}, {0, -3})), Names{"swaths"});
}

/// The same and on along the edges all round the field, where nobody asked for a pass.
TEST(Headlands, RingRoundTheFieldForAnObstacleAtItsEdge) {
  const Path ring{{{6, 10.5}, {9, 10.5}, 0},           {{9, 10.5}, {13.5, 6}, kWideRight},
                  {{13.5, 6}, {18, 1.5}, kWideLeft},   {{18, 1.5}, {94, 1.5}, 0},
                  {{94, 1.5}, {98.5, 6}, kWideLeft},   {{98.5, 6}, {98.5, 54}, 0},
                  {{98.5, 54}, {94, 58.5}, kWideLeft}, {{94, 58.5}, {6, 58.5}, 0},
                  {{6, 58.5}, {1.5, 54}, kWideLeft},   {{1.5, 54}, {1.5, 15}, 0},
                  {{1.5, 15}, {6, 10.5}, kWideLeft}};
  const auto asked_for = [](const Plan& plan) {
    for (const check::Violation& violation : check::verify(plan).violations)
      if (violation.rule == check::Rule::kHeadland &&
          violation.what.find("which was not asked for") != std::string::npos)
        return false;
    return true;
  };
  EXPECT_FALSE(asked_for(corner_plan(ring, true)));
  EXPECT_FALSE(asked_for(turned(corner_plan(ring, true), Angle::degrees(33.3), {-712.3, 455.1})));
  EXPECT_TRUE(asked_for(corner_plan(kFreeSides, false)));
  // A second time round the field.
  Plan twice = headland_plan(1);
  EXPECT_TRUE(asked_for(twice));
  twice.headland.passes.push_back(twice.headland.passes[0]);
  EXPECT_FALSE(asked_for(settled(twice)));
}

TEST(Headlands, PassesThatAreNone) {
  const auto with = [](auto change) {
    Plan plan = headland_plan(2);
    change(plan);
    return found(plan);
  };
  EXPECT_EQ(with([](Plan&) {}), Names{});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].path.erase(p.headland.passes[1].path.begin() + 2); }),
            Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].path.clear(); }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].path[0].to.x = std::nan(""); }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].number = 3; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].number = 0; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].around_field = false; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[1].obstacles = {0}; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.obstacle_passes = {0}; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.headland.passes[0].path = reversed(p.headland.passes[0].path); }),
            Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.settings.headlands = 1; }), Names{"headland"});
  EXPECT_EQ(with([](Plan& p) { p.settings.headlands = -1; }), Names{"headland"});
}

TEST(Headlands, PassesOfObstaclesThatAreNone) {
  Plan plan = island_plan();
  plan.headland.passes[0].path = reversed(plan.headland.passes[0].path);
  EXPECT_EQ(found(plan), Names{"headland"});
  plan = island_plan();
  plan.settings.obstacle_headlands = 0;
  EXPECT_EQ(found(plan), Names{"headland"});
  plan = headland_and_ditch_plan();
  plan.settings.obstacle_headlands = 1;
  plan.headland.obstacle_passes = {1};
  EXPECT_EQ(found(plan), Names{"headland"});
}

TEST(Headlands, FalseFigures) {
  for (const Plan& honest : {headland_plan(2), island_plan(), headland_and_ditch_plan()}) {
    ASSERT_EQ(found(honest), Names{});
    const auto with = [&](auto change) {
      Plan plan = honest;
      change(plan.headland);
      return found(plan);
    };
    EXPECT_EQ(with([](Headland& h) { h.worked_m2 += 0.05; }), Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.overlap_m2 -= 0.05; }), Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.uncovered_m2 += 0.05; }), Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.worked_m2 = std::numeric_limits<double>::quiet_NaN(); }),
              Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.unworked.clear(); }), Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.unworked.push_back({box(90, 1, 91, 2), {}}); }), Names{"tally"});
    EXPECT_EQ(with([](Headland& h) { h.passes.pop_back(); }), Names{"tally"});
  }
  // What lies on the ditch is not worked.
  Plan plan = headland_and_ditch_plan();
  plan.headland.worked_m2 += 9;
  plan.headland.overlap_m2 += 9;
  EXPECT_EQ(found(plan), Names{"tally"});
}

TEST(Headlands, BodyOrHeadlandInTheWrongPlace) {
  const auto with_body = [](const Ring& body, const Ring& ground_from) {
    Plan plan = headland_plan(2);
    plan.body = {{body, {}}};
    plan.subfields[0].shape = plan.body[0];
    plan.headland.ground = {{plan.field.outer, {reversed(ground_from)}}};
    return found(settled(plan));
  };
  const Ring right = box(6, 6, 94, 54), larger = box(6, 6, 94, 54.05);
  EXPECT_EQ(with_body(right, right), Names{});
  EXPECT_EQ(with_body(larger, right), Names{"body"});
  EXPECT_EQ(with_body(right, larger), Names{"body"});
  EXPECT_EQ(with_body(larger, larger), Names{"body"});

  Plan plan = headland_plan(2);
  plan.headland.ground[0].holes[0] = shifted(plan.headland.ground[0].holes[0], {0.05, 0});
  EXPECT_EQ(found(settled(plan)), Names{"body"});
  plan = headland_plan(2);
  plan.headland.ground = {{box(0, 0, 100, 6), {}}};
  EXPECT_EQ(found(settled(plan)), (Names{"body", "headland"})) << "most of the passes is not on it";
  // With the corners of a buffer that is not round.
  plan = island_plan();
  const Ring square = box(37, 24, 63, 36);
  plan.body[0].holes = {reversed(square)};
  plan.subfields[0].shape = plan.body[0];
  plan.headland.ground[0].outer = square;
  EXPECT_TRUE(found(settled(plan)).contains("body"));
}

/// One pass of the three asked for is driven: the ground of the two others is 6 m wide, and tracks have room
/// in it.
TEST(Headlands, GroundLeftToTracks) {
  const auto with_body = [](const Ring& body) {
    Plan plan = headland_plan(3);
    plan.headland.passes.resize(1);
    plan.body = {{body, {}}};
    plan.subfields[0].shape = plan.body[0];
    plan.headland.ground = {{plan.field.outer, {reversed(body)}}};
    std::string out;
    for (const check::Violation& violation : check::verify(plan).violations)
      if (violation.rule == check::Rule::kBody) out += violation.what + "\n";
    return out;
  };
  const Ring behind_one{{3, 5}, {5, 3}, {95, 3}, {97, 5}, {97, 55}, {95, 57}, {5, 57}, {3, 55}};
  EXPECT_EQ(with_body(behind_one), "");
  EXPECT_NE(with_body(box(9, 9, 91, 51)), "") << "there is room for tracks";
  EXPECT_NE(with_body(box(2.5, 3, 97, 57)), "") << "the pass works that";
}

TEST(Headlands, HeadlandWhereNoneWasAskedFor) {
  Plan plan = rectangle_plan();
  plan.headland.ground = {{box(0, 0, 100, 3), {}}};
  EXPECT_EQ(found(settled(plan)), Names{"body"});
}

/// Behind the headland there is nothing to drive on, whatever is said of the boundary.
TEST(Headlands, NoTrackLeavesTheField) {
  Plan plan = headland_plan(1);
  plan.settings.boundary = EdgeKind::kSoft;
  plan.pieces[4].end.x = 99.9;
  EXPECT_EQ(found(settled(plan)), Names{"ends"});
  plan.pieces[4].end.x = 100.1;
  EXPECT_EQ(found(settled(plan)), (Names{"ends", "swaths"}));
}

/// Where a headland goes round the obstacle, its ground may be run into; the obstacle may not.
TEST(Headlands, TracksBeforeAnObstacleWithAHeadland) {
  const auto with_end_at = [](double x) {
    Plan plan = island_plan();
    for (TrackPiece& piece : plan.pieces)
      if (piece.track == 10 && piece.end.x == 37) piece.end.x = x;
    return found(settled(plan));
  };
  EXPECT_EQ(with_end_at(37), Names{});
  EXPECT_EQ(with_end_at(37.1), Names{"ends"});
  // It can turn on the headland: no stop.
  EXPECT_EQ(with_end_at(40), Names{"ends"});
  EXPECT_EQ(with_end_at(40.1), (Names{"ends", "swaths"}));
  Plan plan = island_plan();
  plan.pieces[8].stop_at_end = true;
  EXPECT_EQ(found(plan), Names{"stops"});
}

/// Of random places each is near if it is nearer than the distance: about corners of all kinds, across narrow
/// narrow passages, and where edges are far shorter than the distance.
TEST(Headlands, NearLandIsWhatIsNear) {
  Ring ring{{0, 0}, {60, 0}, {60, 50}, {34, 50}, {33, 12}, {31, 11}, {29, 12}, {28, 50}, {8, 50}};
  for (int i = 1; i < 40; ++i)  // a round bay in the west side
    ring.push_back({8 - 8.0 * i / 40 + 6 * std::sin(std::numbers::pi * i / 40), 50 - 50.0 * i / 40});
  for (const double distance_m : {1.0, 4.0, 9.0}) {
    const Region near = check::land_near(ring, distance_m);
    int in = 0, out = 0;
    for (double x = 0.13; x < 60; x += 0.7)
      for (double y = 0.17; y < 50; y += 0.7) {
        if (!contains(ring, {x, y})) continue;
        double least = 1e9;
        for (std::size_t i = 0; i < ring.size(); ++i)
          least =
              std::min(least, distance_to_edge({ring[i], ring[(i + 1) % ring.size()], 0}, {x, y}, {x, y}));
        if (std::abs(least - distance_m) < check::kFanSagitta_m) continue;
        EXPECT_EQ(contains(near, {x, y}), least < distance_m) << x << ' ' << y << ' ' << least;
        (least < distance_m ? in : out) += 1;
      }
    EXPECT_GT(in, 100);
    EXPECT_GT(out, 100);
  }
}

}  // namespace
}  // namespace tramline
