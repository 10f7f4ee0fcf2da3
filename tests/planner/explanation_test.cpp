#include "tramline/planner/explain/explanation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "planner/prepared.h"
#include "support/refusals.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/planner/plan_field.h"

namespace tramline::explanation_test {

using testing_support::mentions;
using testing_support::refusal_of;

Point at_angle(double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

/// 100 m from west to east, 60 m from south to north; tracks of 3 m.
Field rectangle() {
  Field field;
  field.id = "rectangle";
  field.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  return field;
}

/// Legs of 31 m: 90 m to the east, 120 m to the north.
Field l_shape() {
  Field field;
  field.id = "L";
  field.outer = {{0, 0}, {90, 0}, {90, 31}, {31, 31}, {31, 120}, {0, 120}};
  return field;
}

std::vector<LinedSubfield> driven(double degrees, double origin_m = 0) {
  return {{{{rectangle().outer, {}}, Direction::clockwise_from_north(Angle::degrees(degrees))}, origin_m}};
}

/// A search that has found the rectangle driven east, at no cost but nineteen turns.
struct Search {
  testing::Prepared prepared{{rectangle(), {}, {}, {}}};
  SearchResult found{candidate_on(prepared.task(), driven(90)), 0, {}, {}, {}, {}, {}};

  void see(const std::vector<LinedSubfield>& lined_subfields) {
    found.seen.push_back(seen_plan(candidate_on(prepared.task(), lined_subfields)));
  }
  Explanation explanation() const { return explanation_of(prepared.task(), found, SearchContext(1)); }
};

// Driven north the last of 34 strips has 1 of 3 m on the field: 2 × 60 m² of overlap, and fourteen turns
// more.
void expect_driven_north(const RunnerUp& plan) {
  ASSERT_EQ(plan.directions.size(), 1U);
  EXPECT_NEAR(plan.directions[0].degrees(), 0, 1e-9);
  EXPECT_NEAR(plan.cost, 0.02 * 120 + 1.00 * 33, 1e-3);
  EXPECT_NEAR(plan.more.overlap, 0.02 * 120, 1e-3);
  EXPECT_NEAR(plan.more.uncovered, 0, 1e-3);
  EXPECT_NEAR(plan.more.turns, 1.00 * 14, 1e-9);
  EXPECT_EQ(plan.more.stops, 0);
  EXPECT_STREQ(main_reason(plan.more), "turns");
}

TEST(Explanation, RunnerUpsDifferByMoreThanADegree) {
  Search search;
  search.see(driven(90));
  search.see(driven(90.9));
  search.see(driven(0, 1));
  search.see(driven(0));
  search.see(driven(179.5));
  const Explanation out = search.explanation();
  ASSERT_EQ(out.runner_ups.size(), 1U);
  expect_driven_north(out.runner_ups[0]);
  EXPECT_NEAR(out.causes.of(Cause::kTurns).cost, 1.00 * 19, 1e-9);
}

TEST(Explanation, PlansOnTheShortlistsAreLaidOut) {
  Search shortlisted;
  shortlisted.found.shortlist = {driven(0)};
  ASSERT_EQ(shortlisted.explanation().runner_ups.size(), 1U);
  expect_driven_north(shortlisted.explanation().runner_ups[0]);

  Search swept;
  swept.found.swept = {{driven(90), outlook_on(swept.prepared.task(), driven(90))},
                       {driven(0), outlook_on(swept.prepared.task(), driven(0))}};
  ASSERT_EQ(swept.explanation().runner_ups.size(), 1U);
  expect_driven_north(swept.explanation().runner_ups[0]);
}

TEST(Explanation, NamesTheFiveCheapestOnly) {
  Search search;
  for (const double degrees : {30, 20, 10, 40, 70, 50, 60}) search.see(driven(degrees));
  const std::vector<RunnerUp> runner_ups = search.explanation().runner_ups;
  ASSERT_EQ(runner_ups.size(), 5U);
  for (std::size_t i = 1; i < runner_ups.size(); ++i) EXPECT_LE(runner_ups[i - 1].cost, runner_ups[i].cost);
  int cheaper = 0;
  for (const SeenPlan& seen : search.found.seen) cheaper += seen.cost <= runner_ups.back().cost ? 1 : 0;
  EXPECT_EQ(cheaper, 5);
}

TEST(Explanation, AnotherNumberOfSubfieldsIsAnotherPlan) {
  Search search;
  std::vector<LinedSubfield> halves = driven(90);
  halves.push_back(halves.front());
  halves[0].subfield.shape.outer = {{0, 0}, {50, 0}, {50, 60}, {0, 60}};
  halves[1].subfield.shape.outer = {{50, 0}, {100, 0}, {100, 60}, {50, 60}};
  search.see(halves);
  const Explanation out = search.explanation();
  ASSERT_EQ(out.runner_ups.size(), 1U);
  EXPECT_NEAR(out.runner_ups[0].more.turns, 1.00 * 20, 1e-9);
  EXPECT_NEAR(out.runner_ups[0].more.subfields, 5, 1e-9);
  EXPECT_NEAR(out.runner_ups[0].more.sum(), 1.00 * 20 + 5, 1e-3);
}

// The L driven along its longest side, which runs north: in 31 m across the upper leg 11 strips of 3 m, and
// 59 m of the lower one take 20 more from one end of it.
TEST(Explanation, SaysWhatTheLongestSideWouldCost) {
  Search search;
  search.prepared = {{l_shape(), {}, {}, {}}};
  search.found.best =
      candidate_on(search.prepared.task(),
                   {{{{l_shape().outer, {}}, Direction::clockwise_from_north(Angle::degrees(90))}, 0}});
  const Explanation out = search.explanation();
  ASSERT_EQ(out.longest_side.directions.size(), 1U);
  EXPECT_NEAR(out.longest_side.directions[0].degrees(), 0, 1e-9);
  EXPECT_EQ(out.longest_side.tally.pieces, 30);  // 90 m across
  EXPECT_NEAR(out.longest_side.cost, cost({}, out.longest_side.tally), 1e-9);
  EXPECT_NEAR(out.longest_side.more.sum(), out.longest_side.cost - search.found.best.cost(), 1e-9);
}

TEST(MainReason, IsWhatDiffersMost) {
  EXPECT_STREQ(main_reason({3, 2, -9, 1}), "overlap");
  EXPECT_STREQ(main_reason({1, 2, -9, 1}), "uncovered");
  EXPECT_STREQ(main_reason({1, 2, 9, 1}), "turns");
  EXPECT_STREQ(main_reason({1, 2, -9, 5}), "stops");
  EXPECT_STREQ(main_reason({2, 2, 0, 0}), "overlap") << "among equals the first";
}

TEST(PlanAndExplain, GivesTheSamePlanAndSplitsItsCost) {
  for (const Strategy strategy : {Strategy::kBest, Strategy::kSweep}) {
    SCOPED_TRACE(name(strategy));
    PlanSettings settings;
    settings.strategy = strategy;
    const Plan plan = plan_field(l_shape(), {}, {}, settings, 1);
    const ExplainedPlan one = plan_and_explain(l_shape(), {}, {}, settings, 1);
    const ExplainedPlan two = plan_and_explain(l_shape(), {}, {}, settings, 2);
    EXPECT_EQ(one.plan.cost, plan.cost);
    EXPECT_EQ(one.plan.pieces.size(), plan.pieces.size());
    double sum = 0;
    for (const CausePart& part : one.why->causes.parts) sum += part.cost;
    EXPECT_NEAR(sum, plan.cost, 1e-9);
    // Both sweeps of this field end in the same two directions.
    EXPECT_EQ(one.why->runner_ups.empty(), strategy == Strategy::kSweep);
    ASSERT_EQ(one.why->runner_ups.size(), two.why->runner_ups.size());
    double cost = plan.cost;
    for (std::size_t i = 0; i < one.why->runner_ups.size(); ++i) {
      const RunnerUp& runner_up = one.why->runner_ups[i];
      EXPECT_EQ(runner_up.cost, two.why->runner_ups[i].cost) << "threads do not matter";
      EXPECT_GE(runner_up.cost, cost);
      EXPECT_NEAR(runner_up.more.sum(), runner_up.cost - plan.cost, 1e-9);
      cost = runner_up.cost;
    }
  }
}

// A pole of 1 m in the middle of a strip, far from all edges: everything lost is lost to one detour. Of what
// its swath works, w times its length, w times the stretch it leaves would have been needed.
TEST(PlanAndExplain, OnePoleCostsADetour) {
  Field field = rectangle();
  field.outer = {{0, 0}, {200, 0}, {200, 60}, {0, 60}};
  field.obstacles = {{{{{100, 28}, {101, 28}, {101, 29}, {100, 29}}, {}}, ObstacleKind::kObstacle, "pole"}};
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.decomposition_threshold = Angle::degrees(300);  // no cuts at the pole
  const ExplainedPlan out = plan_and_explain(field, {}, {}, settings, 1);
  double longer_m = 0;
  int detours = 0;
  for (const TrackPiece& piece : out.plan.pieces) {
    longer_m += length(piece) - distance(piece.start, piece.end);
    detours += static_cast<int>(piece.detours.size());
  }
  ASSERT_EQ(detours, 1);
  const CausePart& detour = out.why->causes.of(Cause::kDetours);
  EXPECT_GT(detour.uncovered_m2, 1);
  EXPECT_NEAR(detour.overlap_m2 - detour.uncovered_m2, 3 * longer_m + 1, 1e-6);
  EXPECT_NEAR(detour.cost + out.why->causes.of(Cause::kTurns).cost, out.plan.cost, 1e-3);
}

TEST(PlanAndExplain, LandGivenUpIsACauseOfItsOwn) {
  Field field = rectangle();
  // A gap of 2 m between two sheds: no swath of 3 m fits.
  for (const double x : {40.0, 50.0})
    field.obstacles.push_back(
        {{{{x, 21}, {x + 8, 21}, {x + 8, 30}, {x, 30}}, {}}, ObstacleKind::kObstacle, "shed"});
  PlanSettings settings;
  settings.avoid = Avoidance::kCut;
  const ExplainedPlan out = plan_and_explain(field, {}, {}, settings, 1);
  EXPECT_NEAR(out.why->causes.of(Cause::kGivenUp).uncovered_m2, 2 * 9, 1e-3);
  EXPECT_NEAR(out.why->causes.of(Cause::kGivenUp).cost, 0.10 * 2 * 9, 1e-4);
}

/// A strip 40 m wide that bends along a quarter of a circle, radii 160 and 200 m: tracks along the bend need
/// no more than ten passes.
Field bend() {
  Field field;
  field.id = "bend";
  for (int i = 0; i <= 45; ++i) field.outer.push_back(Point{200, 0} + 200.0 * at_angle(180 - 2.0 * i));
  for (int i = 45; i >= 0; --i) field.outer.push_back(Point{200, 0} + 160.0 * at_angle(180 - 2.0 * i));
  if (signed_area(field.outer) < 0) field.outer = reversed(field.outer);
  return field;
}

TEST(PlanAndExplain, PlansTheShapeThatIsAskedFor) {
  PlanSettings settings;
  for (const TrackShape shape : {TrackShape::kCurved, TrackShape::kAuto}) {
    settings.shape = shape;
    const Plan plan = plan_field(bend(), {}, {}, settings, 1);
    const ExplainedPlan out = plan_and_explain(bend(), {}, {}, settings, 1);
    EXPECT_TRUE(is_curved(out.plan));
    EXPECT_EQ(out.plan.settings.shape, shape);
    EXPECT_EQ(out.plan.cost, plan.cost);
    EXPECT_FALSE(out.why) << "causes are those of straight tracks";
  }
  // Nothing is curved about an L: the cheaper shape is the straight one, and can be explained.
  const ExplainedPlan straight = plan_and_explain(l_shape(), {}, {}, settings, 1);
  EXPECT_EQ(straight.plan.settings.shape, TrackShape::kAuto);
  ASSERT_TRUE(straight.why);
  EXPECT_FALSE(straight.why->runner_ups.empty());
}

TEST(TradeOff, ExplainsTheGivenPlanWithoutAnotherSearch) {
  const ExplainedPlan alone = plan_and_explain(l_shape(), {}, {}, {}, 1);
  const Explanation why = why_given(trade_off(l_shape(), {}, {}, {}, 1), 1);
  ASSERT_EQ(why.runner_ups.size(), alone.why->runner_ups.size());
  for (std::size_t i = 0; i < why.runner_ups.size(); ++i)
    EXPECT_EQ(why.runner_ups[i].cost, alone.why->runner_ups[i].cost);
  EXPECT_EQ(why.longest_side.cost, alone.why->longest_side.cost);
}

TEST(TradeOff, RefusesTracksThatAreNotStraight) {
  PlanSettings settings;
  settings.shape = TrackShape::kAuto;
  EXPECT_TRUE(mentions(refusal_of([&] { trade_off(l_shape(), {}, {}, settings, 1); }), "straight tracks"));
  settings.shape = TrackShape::kStraight;
  settings.tracks = TrackConstruction::kPaper;
  EXPECT_TRUE(mentions(refusal_of([&] { trade_off(l_shape(), {}, {}, settings, 1); }), "as in the paper"));
}

}  // namespace tramline::explanation_test
