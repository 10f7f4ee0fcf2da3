// The metric map of Zhou by hand: headlands, tracks along a line, the three cases of fig. 8.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "planner/prepared.h"
#include "support/box_ring.h"
#include "support/refusals.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/prepare_field.h"

namespace tramline::metric_map_test {

using testing_support::box;

Field field_of(Ring outer, const std::vector<Ring>& obstacles = {}) {
  Field field;
  field.id = "by hand";
  field.outer = std::move(outer);
  for (const Ring& ring : obstacles)
    field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "by hand"});
  return field;
}

/// Zhou's rules: ends cover everything, no piece is too short.
Plan mapped(const Field& field, double width_m, PlanSettings settings) {
  settings.end_rule = EndRule::kCover;
  return plan_field(field, {"", width_m, 6, 0}, {}, settings, 1);
}

PlanSettings along_x(double y, int headlands = 0, int obstacle_headlands = 0) {
  PlanSettings settings;
  settings.guide = {{0, y}, {100, y}};
  settings.headlands = headlands;
  settings.obstacle_headlands = obstacle_headlands;
  return settings;
}

/// What tracks work beyond the body between two heights.
double overlap_between(const Plan& plan, double low, double high) {
  return area(intersection(difference(unite(swaths(plan)), plan.body), {{box(-1000, low, 1000, high), {}}}));
}

/// Σ w·L − overlap + uncovered against the body, as follows from Zhou §2.3.5.
void expect_identity(const Plan& plan) {
  EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6);
  EXPECT_NEAR(plan.track_tally.uncovered_m2, 0, 1e-6);
}

// 200 × 100 m, w = 4, two passes: the body begins 8 m in (Zhou §2.3.3), 184 × 84 m; 21 tracks of 184 m (Zhou
// §2.3.4) that neither overlap nor leave anything.
TEST(MetricMap, OfARectangle) {
  PlanSettings settings;
  settings.headlands = 2;
  const Plan plan = mapped(field_of(box(0, 0, 200, 100)), 4, settings);
  EXPECT_NEAR(area(plan.body), 184.0 * 84.0, 1e-6);
  EXPECT_NEAR(area(plan.headland.ground), 200.0 * 100.0 - 184.0 * 84.0, 1e-6);
  EXPECT_EQ(plan.headland.passes.size(), 2u);
  EXPECT_EQ(plan.tally.pieces, 21);
  EXPECT_NEAR(plan.tally.track_length_m, 21 * 184, 1e-6);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 0, 1e-6);
  EXPECT_EQ(plan.settings.boundary, EdgeKind::kHard);
  expect_identity(plan);
}

// Zhou §2.3.4: 50 m across at w = 4 are ceil(50 / 4) = 13 tracks from the line; the last overhangs by 2 m.
TEST(MetricMap, CountsTracksFromTheLine) {
  const Plan plan = mapped(field_of(box(0, 0, 100, 50)), 4, along_x(0));
  EXPECT_EQ(plan.tally.pieces, 13);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 2 * 100, 1e-6);
  std::set<int> numbers;
  for (const TrackPiece& piece : plan.pieces)
    numbers.insert(std::abs(piece.track + (piece.track < 0 ? 1 : 0)));
  EXPECT_EQ(*numbers.begin(), 0);
  EXPECT_EQ(*numbers.rbegin(), 12);
  expect_identity(plan);
}

// Zhou §2.3.4: a line in the middle has tracks on both sides, numbered 0, 1 … and −1, −2 …
TEST(MetricMap, NumbersTracksOnBothSidesOfTheLine) {
  const Plan plan = mapped(field_of(box(0, 0, 100, 40)), 4, along_x(20));
  std::set<int> numbers;
  for (const TrackPiece& piece : plan.pieces) numbers.insert(piece.track);
  EXPECT_EQ(numbers.size(), 10u);
  EXPECT_EQ(*numbers.begin(), -5);
  EXPECT_EQ(*numbers.rbegin(), 4);
}

// An L of two arms 40 m wide, 100 m long, tracks along x: 10 of 100 m below, 15 of 40 m above.
TEST(MetricMap, OfAnL) {
  const Field field = field_of({{0, 0}, {100, 0}, {100, 40}, {40, 40}, {40, 100}, {0, 100}});
  const Plan plan = mapped(field, 4, along_x(0));
  EXPECT_EQ(plan.tally.pieces, 25);
  EXPECT_NEAR(plan.tally.track_length_m, 10 * 100 + 15 * 40, 1e-6);
  expect_identity(plan);
}

// A block of 20 × 20 m in the middle with a headland of 4 m, so that tracks keep off a square of 28 m with
// round corners of radius 4, y from 16 to 44. Strips from y = 0 in fours:
// - 0 to 3 and 11 to 14 do not meet it (Zhou fig. 8, case 1): 8 tracks of 120 m;
// - 5 to 9 lie within y = 20 … 40, where it is 28 m long: split (case 3) in two pieces of 46 m;
// - 4 and 10 lie in the rounded bands: up to 50 m from either end some of the strip is body (Zhou fig. 9),
// beyond
//   that none: two pieces of 50 m each, over a quarter of the disc of 4 m.
TEST(MetricMap, GoesPastAnObstacleAndStopsAtIt) {
  const Field field = field_of(box(0, 0, 120, 60), {box(50, 20, 70, 40)});
  const Plan plan = mapped(field, 4, along_x(0, 0, 1));
  EXPECT_EQ(plan.headland.obstacle_passes, std::vector<int>{1});
  EXPECT_EQ(plan.tally.pieces, 8 + 2 * 5 + 2 * 2);
  EXPECT_NEAR(plan.tally.track_length_m, 8 * 120 + 10 * 46 + 4 * 50, 0.05);  // chords for the arcs
  const double over = 4 * 0.25 * std::numbers::pi * 16;                      // the quarter discs are headland
  EXPECT_NEAR(plan.track_tally.overlap_m2, over, 0.1);
  expect_identity(plan);
}

// The same with strips from y = 2: that from 14 to 18 m meets the headland in its upper half (Zhou fig. 8,
// case 2) and goes on. Over it: 20 · 2 m² along the block, and at either corner of the arc what lies below y
// = 18, the segment of the disc between u = 0 and √12: ∫ √(16 − u²) − 2 du = √12 + 8 π/3 − 2 √12.
TEST(MetricMap, GoesOnWhereAnObstacleTakesPartOfTheStrip) {
  const Field field = field_of(box(0, 0, 120, 60), {box(50, 20, 70, 40)});
  const Plan plan = mapped(field, 4, along_x(2, 0, 1));
  double whole = 0;
  for (const TrackPiece& piece : plan.pieces)
    if (std::abs(midpoint(piece.start, piece.end).y - 16) < 1e-6) whole += length(piece);
  EXPECT_NEAR(whole, 120, 1e-6);
  const double corner = std::sqrt(12.0) + 8 * std::numbers::pi / 3 - 2 * std::sqrt(12.0);
  EXPECT_NEAR(overlap_between(plan, 14, 18), 2 * 20 + 2 * corner, 0.02);
  expect_identity(plan);
}

// Two blocks: what each takes adds up.
TEST(MetricMap, OfTwoObstacles) {
  const Field field = field_of(box(0, 0, 220, 60), {box(50, 20, 70, 40), box(150, 20, 170, 40)});
  const Plan plan = mapped(field, 4, along_x(0, 0, 1));
  EXPECT_EQ(plan.tally.pieces, 8 + 3 * 5 + 3 * 2);
  EXPECT_NEAR(plan.tally.track_length_m, 8 * 220 + 5 * (220 - 2 * 28) + 2 * (220 - 2 * 20), 0.1);
  expect_identity(plan);
}

// An obstacle that tracks go round keeps no headland: a pole in the middle of a wide field.
TEST(MetricMap, ObstaclesDrivenRoundHaveNoHeadland) {
  PlanSettings settings;
  settings.obstacle_headlands = 1;
  const Plan plan = plan_field(field_of(box(0, 0, 200, 100), {box(99.5, 49.5, 100.5, 50.5)}), {"", 4, 6, 0},
                               {}, settings, 1);
  EXPECT_EQ(plan.headland.obstacle_passes, std::vector<int>{0});
  EXPECT_TRUE(plan.headland.passes.empty());
}

// 40 m across have room for five passes of 4 m along either side: fewer than nine are driven, and it is said.
TEST(MetricMap, DrivesAsManyHeadlandsAsFit) {
  PlanSettings settings;
  settings.headlands = 9;
  const Plan plan = plan_field(field_of(box(0, 0, 100, 40)), {"", 4, 2, 0}, {}, settings, 1);
  for (const HeadlandPass& pass : plan.headland.passes) EXPECT_LE(pass.number, 5);
  EXPECT_LT(plan.tally.uncovered_m2, 0.05 * 100 * 40);
  EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& warning) {
    return warning.find("there is room for") != std::string::npos;
  })) << plan.warnings.size();
}

// A sector of a ring, radii 60.5 and 100 m, 90°: tracks along the outer arc lie at 98, 94 … 62 m from the
// centre, ten of them, their lengths add up to π/2 · 800 m; the innermost overhangs by half a metre, π/2
// · 60.25 · 0.5 m².
TEST(MetricMap, CurvedTracksFollowAnArc) {
  Ring ring;
  const int n = 200;
  for (int i = 0; i <= n; ++i) {
    const double a = 0.5 * std::numbers::pi * i / n;
    ring.push_back({100 * std::cos(a), 100 * std::sin(a)});
  }
  for (int i = n; i >= 0; --i) {
    const double a = 0.5 * std::numbers::pi * i / n;
    ring.push_back({60.5 * std::cos(a), 60.5 * std::sin(a)});
  }
  PlanSettings settings;
  settings.shape = TrackShape::kCurved;
  const Plan plan = mapped(field_of(ring), 4, settings);
  EXPECT_TRUE(is_curved(plan));
  EXPECT_EQ(plan.tally.pieces, 10);
  EXPECT_NEAR(plan.tally.track_length_m, 0.5 * std::numbers::pi * 800, 3);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 0.5 * std::numbers::pi * 60.25 * 0.5, 10);
  settings.shape = TrackShape::kStraight;
  EXPECT_GT(mapped(field_of(ring), 4, settings).cost, plan.cost);
  settings.shape = TrackShape::kAuto;
  EXPECT_EQ(mapped(field_of(ring), 4, settings).cost, plan.cost);
}

// A round field of radius 100 m, w = 6: closed tracks at 97, 91 … m; the machine cannot turn tighter than 6
// m.
TEST(MetricMap, RoundFieldsAreDrivenRoundAndRound) {
  Ring ring;
  for (int i = 0; i < 400; ++i) {
    const double a = 2 * std::numbers::pi * i / 400;
    ring.push_back({100 * std::cos(a), 100 * std::sin(a)});
  }
  PlanSettings settings;
  settings.shape = TrackShape::kAuto;
  const Plan plan = mapped(field_of(ring), 6, settings);
  EXPECT_TRUE(is_curved(plan));
  EXPECT_EQ(plan.tally.pieces, 16);  // 97 … 7 m
  EXPECT_NEAR(plan.tally.track_length_m, 2 * std::numbers::pi * 16 * 52, 2);
}

/// The same map by Zhou's own construction.
Plan as_in_the_paper(const Field& field, double width_m, PlanSettings settings) {
  settings.tracks = TrackConstruction::kPaper;
  return mapped(field, width_m, settings);
}

// Along a straight line Zhou's construction and strips are two roads to one map, wherever it is anchored.
TEST(MetricMap, OfAStraightLineIsTheSameByThePapersConstruction) {
  const Field field = field_of({{0, 0}, {120, 0}, {131, 38}, {120, 70}, {40, 25}, {3, 60}});
  for (const AbAnchor anchor : {AbAnchor::kLine, AbAnchor::kEnvelope})
    for (const double y : {-3.0, 0.0, 11.0})
      for (const double rise : {0.0, 17.0}) {
        PlanSettings settings = along_x(y);
        settings.guide.back().y += rise;
        settings.ab_anchor = anchor;
        const Plan strips = mapped(field, 4, settings), paper = as_in_the_paper(field, 4, settings);
        EXPECT_EQ(paper.tally.pieces, strips.tally.pieces);
        EXPECT_NEAR(paper.tally.track_length_m, strips.tally.track_length_m, 0.01);
        EXPECT_NEAR(paper.track_tally.overlap_m2, strips.track_tally.overlap_m2, 0.05);
        EXPECT_NEAR(paper.cost, strips.cost, 0.01);
        EXPECT_NEAR(area(symmetric_difference(paper.overlap, strips.overlap)), 0, 0.1);
        EXPECT_FALSE(is_curved(paper));
        // Booleans move corners by micrometres.
        EXPECT_NEAR(paper.track_tally.uncovered_m2, 0, 1e-2);
        EXPECT_NEAR(identity_error_m2(paper), 0, 1e-2);
      }
}

// 100 × 60 m, w = 4, one pass, the line across the middle: the body is 92 × 52 m and its envelope itself.
// Zhou's τ = ⌈52/4⌉ = 13 tracks of 92 m work it without overlap. From a line at y = 30 the borders of swaths
// are at y = 2, 6 … 58: 14 of them for a body from 4 to 56, so that 2 m at either side, 368 m² in all, are
// worked twice.
TEST(MetricMap, BegunAtTheEnvelopeSavesATrack) {
  const Field field = field_of(box(0, 0, 100, 60));
  PlanSettings settings = along_x(30, 1);
  settings.guide = {{40, 30}, {60, 30}};
  const Plan line = mapped(field, 4, settings);
  EXPECT_EQ(line.tally.pieces, 14);
  EXPECT_NEAR(line.track_tally.overlap_m2, 368, 0.02);
  EXPECT_EQ(line.settings.ab_anchor, AbAnchor::kLine);
  settings.ab_anchor = AbAnchor::kEnvelope;
  for (const bool reversed : {false, true}) {
    if (reversed) std::swap(settings.guide.front(), settings.guide.back());
    const Plan envelope = mapped(field, 4, settings);
    EXPECT_EQ(envelope.tally.pieces, 13);
    EXPECT_NEAR(envelope.tally.track_length_m, 13 * 92, 1e-6);
    EXPECT_NEAR(envelope.track_tally.overlap_m2, 0, 1e-3);
    expect_identity(envelope);
    // On the left of the line: north of one to the east, south of one to the west.
    ASSERT_EQ(envelope.subfields[0].reference.size(), 1U);
    EXPECT_NEAR(envelope.subfields[0].reference[0].from.y, reversed ? 4 : 56, 1e-9);
    for (const TrackPiece& piece : envelope.pieces)
      EXPECT_NEAR(std::abs(piece.start.y - envelope.subfields[0].reference[0].from.y),
                  std::abs(piece.track + 0.5) * 4, 1e-6);
  }
}

// The same by the paper's construction, headland included: the pass runs 2 m in, 2·(96 + 56) = 304 m, and
// works the 6000 − 92·52 = 1216 m² = 4·304 of the headland once, corners too.
TEST(MetricMap, OfARectangleByThePaperHasNoOverlapAtAll) {
  PlanSettings settings = along_x(30, 1);
  const Plan plan = as_in_the_paper(field_of(box(0, 0, 100, 60)), 4, settings);
  EXPECT_EQ(plan.settings.ab_anchor, AbAnchor::kEnvelope);
  EXPECT_EQ(plan.tally.pieces, 13);
  EXPECT_NEAR(area(plan.body), 92 * 52, 1e-6);
  ASSERT_EQ(plan.headland.passes.size(), 1U);
  EXPECT_NEAR(length(plan.headland), 304, 1e-9);
  EXPECT_NEAR(plan.headland.worked_m2, 1216, 1e-6);
  EXPECT_NEAR(plan.headland.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(plan.headland.uncovered_m2, 0, 1e-6);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-2);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-2);
  EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6);
}

// At 45° the 92 × 52 m of the body are (92 + 52)/√2 = 101.82 m across: τ = ⌈25.46⌉ = 26.
TEST(MetricMap, BegunAtATurnedEnvelope) {
  PlanSettings settings;
  settings.headlands = 1;
  settings.guide = {{50, 30}, {60, 40}};
  const Plan plan = as_in_the_paper(field_of(box(0, 0, 100, 60)), 4, settings);
  EXPECT_EQ(plan.tally.pieces, 26);
  EXPECT_NEAR(plan.track_tally.uncovered_m2, 0, 1e-2);
  // Through the corner (4, 56), the farthest on the left.
  const PathSegment& side = plan.subfields[0].reference.front();
  EXPECT_NEAR(distance_to_edge(side, {4, 56}, {4, 56}), 0, 1e-6);
}

// An L, w = 4, one pass: the ring keeps 2 m off with a corner at (18, 18), beside the corner (20, 20) that
// stands out into the land, 184 m in all. The body has a corner at (16, 16): 52·12 + 12·20 = 864 m², and the
// headland 1600 − 864 = 736 = 4·184 m². The body is 32 m high and begins at y = 36: 8 tracks, 5 of 12 m and 3
// of 52 m.
TEST(MetricMap, OfAnLByThePaper) {
  const Field field = field_of({{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 40}, {0, 40}});
  const Plan plan = as_in_the_paper(field, 4, along_x(10, 1));
  ASSERT_EQ(plan.headland.passes.size(), 1U);
  EXPECT_EQ(plan.headland.construction, HeadlandConstruction::kPlain);
  EXPECT_NEAR(length(plan.headland), 184, 1e-9);
  EXPECT_NEAR(area(plan.body), 864, 1e-6);
  EXPECT_NEAR(plan.headland.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(plan.headland.uncovered_m2, 0, 1e-6);
  EXPECT_EQ(plan.tally.pieces, 8);
  EXPECT_NEAR(plan.tally.track_length_m, 5 * 12 + 3 * 52, 1e-3);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 0, 1e-2);
}

// Two passes round a square obstacle of 10 m: rings of 14 and 22 m a side, and 26 m for the border b.
TEST(MetricMap, OfAnObstacleByThePaper) {
  const Field field = field_of(box(0, 0, 100, 80), {box(40, 35, 50, 45)});
  const Plan plan = as_in_the_paper(field, 4, along_x(10, 1, 2));
  ASSERT_EQ(plan.headland.passes.size(), 3U);
  EXPECT_NEAR(length(plan.headland), 2 * (96 + 76) + 4 * 14 + 4 * 22, 1e-9);
  EXPECT_NEAR(area(plan.body), 92 * 72 - 26 * 26, 1e-6);
  EXPECT_NEAR(plan.headland.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(plan.headland.uncovered_m2, 0, 1e-6);
}

// 5 m from the edge, w = 4, an obstacle's pass and that of the field would overlap: they are one ring, which
// keeps w/2 off both. Between them, where the centre lines are to be 2 m from either, is room for it.
TEST(MetricMap, PlainPassesThatMeetAreOneRing) {
  const Field field = field_of(box(0, 0, 100, 80), {box(40, 3, 50, 13)});
  const Plan plan = as_in_the_paper(field, 4, along_x(10, 1, 1));
  ASSERT_EQ(plan.headland.passes.size(), 1U);
  const HeadlandPass& pass = plan.headland.passes[0];
  EXPECT_TRUE(pass.around_field);
  EXPECT_EQ(pass.obstacles, std::vector<std::size_t>{0});
  // Up from y = 2 to 15 and down again, 14 m apart.
  EXPECT_NEAR(length(pass.path), 2 * (96 + 76) + 2 * 13, 1e-6);
}

TEST(MetricMap, RefusesAnEnvelopeWithoutAStraightLine) {
  const Field field = field_of(box(0, 0, 100, 60));
  PlanSettings settings;
  settings.ab_anchor = AbAnchor::kEnvelope;
  EXPECT_REFUSED(mapped(field, 4, settings));
  settings.guide = {{0, 0}, {50, 10}, {100, 0}};
  settings.shape = TrackShape::kCurved;
  EXPECT_REFUSED(mapped(field, 4, settings));
}

// A line that turns by 60° along the edge of a field of the same shape, 100 m to either side of the kink and
// 20 m deep. Five tracks, each 2 w tan 30° longer than the last; nothing is left and nothing worked twice.
TEST(MetricMap, HasKinksByThePapersConstruction) {
  const double turn = std::numbers::pi / 3, tangent = std::tan(0.5 * turn);
  const Point along{std::cos(turn), std::sin(turn)}, right{std::sin(turn), -std::cos(turn)};
  const Field field =
      field_of({{-100, 0}, {-100, -20}, {20 * tangent, -20}, 100 * along + 20 * right, 100 * along, {0, 0}});
  PlanSettings settings;
  settings.guide = {{-100, 0}, {0, 0}, 100 * along};
  settings.shape = TrackShape::kCurved;
  const Plan plan = as_in_the_paper(field, 4, settings);
  EXPECT_EQ(plan.tally.pieces, 5);
  EXPECT_NEAR(plan.tally.track_length_m, 5 * 200 + 2 * 4 * tangent * (0.5 + 1.5 + 2.5 + 3.5 + 4.5), 1e-3);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 0, 1e-2);
  EXPECT_NEAR(area(plan.overlap), 0, 1e-2);
  EXPECT_NEAR(area(plan.uncovered), 0, 1e-2);
  EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6);
  for (const TrackPiece& piece : plan.pieces) EXPECT_EQ(piece.curve.size(), 2u);
}

TEST(MetricMap, RefusesWhatThePaperDoesNotKnow) {
  const Field pond = field_of(box(0, 0, 100, 50), {box(40, 20, 60, 30)});
  EXPECT_REFUSED(as_in_the_paper(pond, 4, along_x(0))) << "no headland round the obstacle";
  EXPECT_NO_THROW(as_in_the_paper(pond, 4, along_x(0, 0, 1)));
  const Field bare = field_of(box(0, 0, 100, 50));
  EXPECT_REFUSED(as_in_the_paper(bare, 4, {})) << "no line";
  PlanSettings hard = along_x(0);
  hard.boundary = EdgeKind::kHard;
  EXPECT_REFUSED(as_in_the_paper(bare, 4, hard));
  PlanSettings inside = along_x(0);
  inside.tracks = TrackConstruction::kPaper;
  inside.end_rule = EndRule::kInside;
  EXPECT_REFUSED(plan_field(bare, {"", 4, 6, 0}, {}, inside, 1));
}

// An obstacle 2 m from the edge, the strip between them too narrow for anything: 20 by 2 m, all of it in the
// headland. No swath enters it, but to end before it is no stop, and it is not the body's to be left.
TEST(MetricMap, LandGivenUpInAHeadlandIsNoObstacle) {
  PlanSettings settings;
  settings.headlands = 1;
  const Field field = field_of(box(0, 0, 100, 60), {box(2, 20, 12, 40)});
  const PlanningProblem problem = planning_problem(field, {"", 6, 6, 0}, {}, settings);
  const ClassifiedGround ground = prepare_field(problem, SearchContext(1)).value().field.ground;
  EXPECT_NEAR(area(ground.hard), 200, 1e-6);
  EXPECT_NEAR(area(ground.beyond), 40, 1e-6);
  EXPECT_NEAR(area(ground.given_up), 0, 1e-6);
}

/// Round so small a part of the ground no curve is wide enough for the machine.
TEST(MetricMap, ALineAllRoundThatSmoothingLeavesNothingOfIsRefused) {
  const Machine machine{"", 12, 6, 0};
  PlanSettings settings;
  settings.shape = TrackShape::kCurved;
  const testing::Prepared prepared{{field_of(box(0, 0, 100, 100)), machine, {}, settings}};
  const SearchTask task = prepared.task();
  const std::vector<Point> round{{20.000, 24.6690}, {18.307, 18.9730}, {12.523, 20.7820}, {12.495, 24.2460},
                                 {12.456, 30.3060}, {21.870, 30.3660}, {20.0003, 24.6700}};
  EXPECT_REFUSED(reference_along(task, round, 6));
  EXPECT_FALSE(reference_along(task, {{0, 0}, {60, 20}, {100, 0}}, 6).round);
}

}  // namespace tramline::metric_map_test
