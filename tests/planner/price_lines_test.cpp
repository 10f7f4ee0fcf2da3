// Given lines on a field of 60 m × 40 m with a machine 4 m wide: figures by hand.

#include "tramline/planner/price/price_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/refusals.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::price_lines_test {

constexpr double kWidth = 4;
constexpr double kField_m2 = 60 * 40;
constexpr Objective kPrices{0.02, 0.10, 1, 5, 5};

Polygon box_polygon(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

Field rectangle() {
  Field out;
  out.id = "rectangle";
  out.outer = box_polygon(0, 0, 60, 40).outer;
  return out;
}

Field with(Field field, const Polygon& shape, ObstacleKind kind = ObstacleKind::kObstacle) {
  field.obstacles.push_back({shape, kind, "by hand"});
  return field;
}

GivenLine line_through(const std::vector<Point>& points) {
  GivenLine out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) out.path.push_back({points[i], points[i + 1], 0});
  out.name = "a line";
  return out;
}

PricedLines priced(const Field& field, const GivenLines& lines, double clearance_m = 0) {
  Machine machine;
  machine.width_m = kWidth;
  return price_lines(field, machine, kPrices, lines, clearance_m);
}

Plan price(const Field& field, const std::vector<std::vector<Point>>& lines) {
  GivenLines given;
  for (const std::vector<Point>& points : lines) given.tracks.push_back(line_through(points));
  return priced(field, given).plan;
}

/// Figures are those of the lines by another road, and the identity holds.
void expect_sound(const Plan& plan) {
  EXPECT_NEAR(identity_error_m2(plan), 0, 1e-9);
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.complete);
  for (const check::Violation& violation : verdict.violations)
    ADD_FAILURE() << name(violation.rule) << ": " << violation.what;
}

void expect_tally(const Plan& plan, double overlap_m2, double uncovered_m2, int turns, int stops = 0) {
  EXPECT_NEAR(plan.tally.overlap_m2, overlap_m2, 1e-9);
  EXPECT_NEAR(plan.tally.uncovered_m2, uncovered_m2, 1e-9);
  EXPECT_EQ(plan.tally.turns, turns);
  EXPECT_EQ(plan.tally.stops, stops);
  EXPECT_NEAR(plan.cost, 0.02 * overlap_m2 + 0.10 * uncovered_m2 + turns + 5 * stops, 1e-9);
  EXPECT_NEAR(area(plan.overlap) > 0 ? 1 : 0, overlap_m2 > 0 ? 1 : 0, 0);
  EXPECT_NEAR(area(plan.uncovered), uncovered_m2, 1e-3);
  expect_sound(plan);
}

// Side by side, a width apart: 2 · 4 · 60 m² of 2,400 are worked, once.
TEST(PriceLines, ParallelLinesAWidthApartHaveNoOverlap) {
  const Plan plan = price(rectangle(), {{{0, 2}, {60, 2}}, {{60, 6}, {0, 6}}});
  expect_tally(plan, 0, kField_m2 - 480, 1);
  EXPECT_EQ(plan.tally.pieces, 2);
  EXPECT_NEAR(plan.tally.track_length_m, 120, 1e-12);
  EXPECT_EQ(plan.origin, PlanOrigin::kLines);
  EXPECT_TRUE(plan.pieces[0].curve.empty());
}

TEST(PriceLines, ALineDrivenTwiceOverlapsWithAllItsSwath) {
  const Plan plan = price(rectangle(), {{{0, 10}, {60, 10}}, {{60, 10}, {0, 10}}});
  expect_tally(plan, 4 * 60, kField_m2 - 240, 1);
  EXPECT_NEAR(*plan.pieces[0].overlap_m2, 0, 1e-9);
  EXPECT_NEAR(*plan.pieces[1].overlap_m2, 240, 1e-9);
}

// Half of 40 m lies beyond the edge x = 60.
TEST(PriceLines, WorkOutsideTheFieldIsOverlap) {
  expect_tally(price(rectangle(), {{{40, 10}, {80, 10}}}), 4 * 20, kField_m2 - 80, 0);
}

// The square where they cross counts twice.
TEST(PriceLines, CrossingLinesOverlapWhereTheyCross) {
  expect_tally(price(rectangle(), {{{0, 20}, {60, 20}}, {{30, 0}, {30, 40}}}), 16,
               kField_m2 - 4 * (60 + 40) + 16, 1);
}

// A right angle is mitred: what the swath gains outside the kink it loses inside, and w·L = 4 · 60.
TEST(PriceLines, AKinkedLineWorksItsWidthTimesItsLength) {
  const Plan plan = price(rectangle(), {{{10, 10}, {50, 10}, {50, 30}}});
  expect_tally(plan, 0, kField_m2 - 240, 0);
  EXPECT_EQ(plan.pieces[0].curve.size(), 2u);
  EXPECT_NEAR(*plan.pieces[0].overlap_m2, 0, 1e-9);
}

// Straight back on itself: both ends of the fold are flat, the second half lies on the first.
TEST(PriceLines, ALineThatFoldsBackWorksItsLandTwice) {
  expect_tally(price(rectangle(), {{{10, 10}, {50, 10}, {20, 10}}}), 4 * 30, kField_m2 - 160, 0);
}

// Itself crossed, at a right angle, on a way of 4 straight stretches.
TEST(PriceLines, ALineThatCrossesItselfOverlapsThere) {
  const Plan plan = price(rectangle(), {{{10, 20}, {50, 20}, {50, 30}, {30, 30}, {30, 5}}});
  expect_tally(plan, 16, kField_m2 - 4 * (40 + 10 + 20 + 25) + 16, 0);
}

// 10 m of the line lie on the obstacle: that is no land to work, so 4 · 10 m² are overlap. Beside it nothing
// is missed more than anywhere else.
TEST(PriceLines, WorkOnAnObstacleIsOverlap) {
  const Plan plan = price(with(rectangle(), box_polygon(25, 15, 35, 25)), {{{0, 20}, {60, 20}}});
  expect_tally(plan, 40, kField_m2 - 100 - 200, 0);
  EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& warning) {
    return warning == "the swaths of 1 line work 40.0 m² of obstacles";
  }));
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(std::any_of(verdict.findings.begin(), verdict.findings.end(),
                          [](const check::Violation& v) { return v.rule == check::Rule::kSwaths; }));
}

// Cut before and behind the obstacle: two stops, and a turn.
TEST(PriceLines, EndsAgainstAnObstacleAreStops) {
  const Field field = with(rectangle(), box_polygon(25, 15, 35, 25));
  const Plan plan = price(field, {{{0, 20}, {25, 20}}, {{35, 20}, {60, 20}}});
  expect_tally(plan, 0, kField_m2 - 100 - 200, 1, 2);
  EXPECT_TRUE(plan.pieces[0].stop_at_end);
  EXPECT_TRUE(plan.pieces[1].stop_at_start);
  EXPECT_FALSE(plan.pieces[0].stop_at_start);
  // Two centimetres before it there is room to stop.
  EXPECT_EQ(price(field, {{{0, 20}, {24.98, 20}}}).tally.stops, 0);
}

// 2 m of land between two obstacles are narrower than the machine: an end against them is a stop, too.
TEST(PriceLines, EndsAgainstLandTooNarrowForTheMachineAreStops) {
  const Field field = with(with(rectangle(), box_polygon(25, 10, 35, 19)), box_polygon(25, 21, 35, 30));
  const Plan plan = price(field, {{{0, 20}, {25, 20}}});
  EXPECT_EQ(plan.tally.stops, 1);
  EXPECT_NEAR(area(plan.given_up), 20, 1e-6);
  expect_sound(plan);
}

// A grassed waterway from y = 0 to 40: no turn beyond it for the line that goes on, one for a line beside it.
TEST(PriceLines, ALineGoesOnBehindAPassableObstacleWithoutATurn) {
  const Field field = with(rectangle(), box_polygon(28, 0, 32, 40), ObstacleKind::kPassable);
  const Plan plan =
      price(field, {{{0, 20}, {28, 20}}, {{32, 20}, {60, 20}}, {{60, 24}, {32, 24}}, {{28, 28}, {0, 28}}});
  EXPECT_EQ(plan.tally.crossings, 1);
  EXPECT_EQ(plan.tally.turns, 2);
  EXPECT_TRUE(plan.pieces[1].after_crossing);
  EXPECT_EQ(plan.pieces[1].track, plan.pieces[0].track);
  EXPECT_FALSE(plan.pieces[3].after_crossing);  // 4 m beside the line before it
  expect_sound(plan);
}

TEST(PriceLines, ALineThatIsKnownToBeginWithATurnIsNoCrossing) {
  const Field field = with(rectangle(), box_polygon(28, 0, 32, 40), ObstacleKind::kPassable);
  GivenLines lines;
  lines.tracks = {line_through({{0, 20}, {28, 20}}), line_through({{32, 20}, {60, 20}})};
  EXPECT_EQ(priced(field, lines).plan.tally.crossings, 1);
  lines.tracks[1].way_here = WayHere::kTurn;
  EXPECT_EQ(priced(field, lines).plan.tally.crossings, 0);
}

TEST(PriceLines, LinesWithoutLengthAreListedAndLeftOut) {
  GivenLines lines;
  lines.tracks = {line_through({{5, 5}, {5, 5}, {5, 5}}),
                  line_through({{0, 2}, {0, 2}, {30, 2}, {30, 2}, {60, 2}}), line_through({{7, 7}})};
  const PricedLines found = priced(rectangle(), lines);
  EXPECT_EQ(found.skipped.size(), 2u);
  expect_tally(found.plan, 0, kField_m2 - 240, 0);
}

TEST(PriceLines, AMillimetreOfALineIsALine) {
  const Plan plan = price(rectangle(), {{{30, 20}, {30.001, 20}}});
  EXPECT_EQ(plan.tally.pieces, 1);
  EXPECT_NEAR(plan.tally.worked_m2, 0.004, 1e-12);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-9);
}

// A lap of 40 m × 20 m, mitred at three corners; the fourth, where it begins and ends, has flat ends, which
// share a quarter of w² and leave as much out.
TEST(PriceLines, AClosedLineKeepsItsEndsApart) {
  const Plan plan = price(rectangle(), {{{10, 10}, {50, 10}, {50, 30}, {10, 30}, {10, 10}}});
  EXPECT_NEAR(plan.tally.worked_m2, 4 * 120, 1e-3);
  EXPECT_NEAR(plan.tally.overlap_m2, 4, 1e-3);
  EXPECT_NE(plan.pieces[0].start, plan.pieces[0].end);
  expect_sound(plan);
}

// Arcs of 5 m are kept exact; those of 1 m are tighter than half the width, and are worked along chords.
TEST(PriceLines, ArcsAreKeptWhereTheSwathLiesFlat) {
  const auto half_circle = [](double radius_m) {
    GivenLine out;
    out.path = {{{30 - radius_m, 20}, {30 + radius_m, 20}, -1 / radius_m}};
    return out;
  };
  GivenLines lines;
  lines.tracks = {half_circle(5)};
  const Plan wide = priced(rectangle(), lines).plan;
  EXPECT_EQ(wide.pieces[0].curve.size(), 1u);
  EXPECT_NEAR(wide.tally.overlap_m2, 0, 1e-9);
  EXPECT_NEAR(wide.tally.worked_m2, 4 * 5 * std::numbers::pi, 1e-9);
  expect_sound(wide);
  lines.tracks = {half_circle(1)};
  const Plan tight = priced(rectangle(), lines).plan;
  EXPECT_GT(tight.pieces[0].curve.size(), 10u);
  EXPECT_GT(tight.tally.overlap_m2, 1);
  expect_sound(tight);
}

// A pass along the lower edge works 4 · 60 m² of headland. The track beside it begins in it, 1 m deep: 4 m²
// are worked twice. Passes are no tracks: no turn is counted between the two.
TEST(PriceLines, PassesCountAsHeadland) {
  GivenLines lines;
  lines.tracks = {line_through({{10, 3}, {10, 40}})};
  lines.passes = {line_through({{0, 2}, {60, 2}})};
  const Plan plan = priced(rectangle(), lines).plan;
  expect_tally(plan, 4, kField_m2 - 240 - 4 * 36, 0);
  EXPECT_NEAR(area(plan.headland.ground), 240, 1e-6);
  EXPECT_NEAR(area(plan.body), kField_m2 - 240, 1e-6);
  EXPECT_NEAR(plan.track_tally.overlap_m2, 4, 1e-6);  // of the body it works 36 m
  EXPECT_EQ(plan.tally.pieces, 1);
}

TEST(PriceLines, LinesOfSeveralSubfieldsPayForThem) {
  GivenLines lines;
  lines.tracks = {line_through({{0, 2}, {60, 2}}), line_through({{2, 4}, {2, 40}})};
  EXPECT_EQ(priced(rectangle(), lines).plan.tally.subfields, 1);
  lines.tracks[0].subfield = 3;
  lines.tracks[1].subfield = 7;
  const Plan plan = priced(rectangle(), lines).plan;
  EXPECT_EQ(plan.tally.subfields, 2);
  EXPECT_EQ(plan.subfields.size(), 2u);
  EXPECT_NEAR(plan.subfields[1].direction.degrees(), 0, 1e-9);
  EXPECT_NEAR(plan.subfields[0].direction.degrees(), 90, 1e-9);
  expect_sound(plan);
}

TEST(PriceLines, LinesOutsideTheFieldAreRefused) {
  EXPECT_REFUSED(price(rectangle(), {{{0, 100}, {60, 100}}}));
  EXPECT_REFUSED(price(rectangle(), {{{5, 5}, {5, 5}}}));
  EXPECT_REFUSED(price(rectangle(), {}));
  // One that reaches the field will do; the other is said to work nothing of it.
  const Plan plan = price(rectangle(), {{{0, 2}, {60, 2}}, {{0, 100}, {60, 100}}});
  expect_tally(plan, 240, kField_m2 - 240, 1);
  EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& warning) {
    return warning.find("1 of 2 lines works nothing of the field") != std::string::npos;
  }));
}

// With other figures the verifier finds the plan wrong.
TEST(PriceLines, WrongFiguresAreViolations) {
  const Plan plan = price(rectangle(), {{{0, 2}, {60, 2}}, {{60, 5}, {0, 5}}});
  expect_sound(plan);
  Plan less = plan;
  less.tally.overlap_m2 -= 1;
  EXPECT_FALSE(check::verify(less).holds());
  Plan stop = plan;
  stop.pieces[0].stop_at_end = true;
  EXPECT_FALSE(check::verify(stop).holds());
  Plan planned = plan;
  planned.origin = PlanOrigin::kPlanned;
  EXPECT_FALSE(check::verify(planned).holds());  // of a plan made here the rules are asked for
}

// 3 m apart with a width of 4 m.
TEST(PriceLines, LinesTooNearToOneAnotherAreFindings) {
  const check::Verdict verdict = check::verify(price(rectangle(), {{{0, 2}, {60, 2}}, {{60, 5}, {0, 5}}}));
  EXPECT_TRUE(verdict.holds());
  EXPECT_TRUE(std::any_of(verdict.findings.begin(), verdict.findings.end(),
                          [](const check::Violation& v) { return v.rule == check::Rule::kParallel; }));
}

// Two half circles of 10 m work a ring of 2π·10 m × 4 m; opened by a tenth of a millimetre, which is 4 cm².
TEST(PriceLines, AClosedTrackKeepsItsArcs) {
  GivenLines given;
  given.tracks.push_back({{{{40, 20}, {20, 20}, 0.1}, {{20, 20}, {40, 20}, 0.1}}, 0, "ring"});
  const Plan plan = priced(rectangle(), given).plan;
  ASSERT_EQ(plan.pieces.size(), 1u);
  EXPECT_NEAR(smallest_radius(centre_line(plan.pieces[0])), 10, 1e-9);
  EXPECT_NEAR(plan.tally.track_length_m, 20 * std::numbers::pi, 1.1e-4);
  EXPECT_NEAR(plan.tally.uncovered_m2, kField_m2 - 80 * std::numbers::pi, 5e-4);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 5e-4);
}

}  // namespace tramline::price_lines_test
