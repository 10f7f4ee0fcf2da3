// Ends of tracks that are left early or begun late so that the machine turns at once.

#include "tramline/planner/whole/shorter_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

/// A machine 12 m wide that turns round at 6 m: half a circle leads from a track to the next one, and takes
/// all of a headland of one pass.
constexpr double kWidth_m = 12, kRadius_m = 6;
constexpr double kHalfCircle_m = std::numbers::pi * kRadius_m;

/// 200 m by 120 m; from one track to the next the eastern edge recedes by `farther_m`.
PlanningProblem with_oblique_edge(double farther_m) {
  const double far_m = 200 + 10 * farther_m;
  Field field;
  field.id = "oblique";
  field.outer = {{0, 0}, {200, 0}, {far_m, 120}, {0, 120}};
  Machine machine;
  machine.width_m = kWidth_m;
  machine.radius_m = kRadius_m;
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.aim = Aim::kWholeCost;
  settings.boundary = EdgeKind::kHard;
  return planning_problem(field, machine, {}, settings);
}

/// Behind one pass all round, tracks from east to west.
HeadlandTrial trial_behind_one_pass(const PlanningProblem& problem) {
  Plan layout;
  layout.machine = problem.machine;
  layout.subfields.push_back(
      {{problem.field.outer, {}}, Direction::clockwise_from_north(Angle::degrees(90))});
  std::optional<HeadlandTrial> out =
      headland_trial(problem, layout, {{1, 1, 1, 1}, {}}, Offset::kBest, SearchContext(1));
  if (!out) throw std::logic_error("no track fits");
  return std::move(*out);
}

PlanDraft redrafted(const HeadlandTrial& trial) {
  return drafted(SearchTask(trial.problem, trial.prepared), trial.found);
}

/// The longest way between two tracks on a route, m.
double longest_between_tracks_m(const Plan& plan) {
  double longest_m = 0, since_m = 0;
  bool after_track = false;
  for (const RouteLeg& leg : plan.route.legs) {
    if (!leg.work) {
      since_m += length(leg);
      continue;
    }
    if (after_track && leg.piece) longest_m = std::max(longest_m, since_m);
    after_track = leg.piece.has_value();
    since_m = 0;
  }
  return longest_m;
}

double length_m(const Plan& plan) {
  double out = 0;
  for (const TrackPiece& piece : plan.pieces) out += length(piece);
  return out;
}

/// The most that a piece's end is moved along its track, m. Both plans have the same tracks.
double most_shortened_m(const Plan& before, const Plan& after) {
  double out = 0;
  for (const TrackPiece& piece : after.pieces)
    for (const TrackPiece& whole : before.pieces)
      if (piece.track == whole.track) out = std::max(out, length(whole) - length(piece));
  return out;
}

// The edge recedes by 0.2 m from each of the eight tracks to the next. Half a circle from the end of one
// leads to a place 0.2 m behind the beginning of the next, and there is no room farther out: once round a
// circle more, 37.7 m at 1.5 m/s. Begun 0.2 m late, the next one leaves a triangle of 12 · 0.2 / 2 = 1.2 m².
TEST(EndsWorthShortening, AreThoseBehindTheirNeighbours) {
  const PlanningProblem problem = with_oblique_edge(0.2);
  const HeadlandTrial whole = trial_behind_one_pass(problem);
  const Plan& before = whole.draft.plan;
  ASSERT_EQ(before.pieces.size(), 8U);
  EXPECT_GT(longest_between_tracks_m(before), 2.5 * kHalfCircle_m);

  const std::vector<ShorterEnds> ends = ends_worth_shortening(whole);
  ASSERT_GE(ends.size(), 3U);
  double saved = 0;
  for (const ShorterEnds& one : ends) {
    EXPECT_LT(one.end_m + one.start_m, 0.3);
    saved += one.saved;
  }
  EXPECT_LE(saved, most_saved_by_shorter_ends(whole));

  const PlanDraft draft = redrafted(shortened(ends, whole));
  const Plan& after = draft.plan;
  EXPECT_EQ(after.pieces.size(), before.pieces.size());
  EXPECT_LT(longest_between_tracks_m(after), 1.1 * kHalfCircle_m);
  EXPECT_LT(most_shortened_m(before, after), 0.3);
  EXPECT_LT(after.tally.uncovered_m2 - before.tally.uncovered_m2, static_cast<double>(ends.size()) * 1.8);
  const double less_m2 = (length_m(before) - length_m(after)) * kWidth_m;
  EXPECT_NEAR(
      less_m2,
      after.tally.uncovered_m2 - before.tally.uncovered_m2 + before.tally.overlap_m2 - after.tally.overlap_m2,
      1e-6);
  // What was foreseen is about what is saved.
  EXPECT_NEAR(whole_cost(before).euros() - whole_cost(after).euros(), saved, 0.1 * saved);
}

// 2.5 m farther, the triangle of 15 m² is worth 1.05 EUR at a margin of 700 EUR/ha, and a circle costs less.
TEST(EndsWorthShortening, AreNoneWhereTheLandIsWorthMore) {
  const HeadlandTrial trial = trial_behind_one_pass(with_oblique_edge(2.5));
  EXPECT_GT(most_saved_by_shorter_ends(trial), 2) << "three circles, a euro each";
  for (const ShorterEnds& one : ends_worth_shortening(trial)) EXPECT_LT(one.end_m + one.start_m, 0.3);
}

// Where hours cost nothing there is nothing to save.
TEST(EndsWorthShortening, AreNoneWhereTimeCostsNothing) {
  PlanningProblem problem = with_oblique_edge(0.2);
  problem.machine.rates.price_per_hour = problem.machine.rates.fuel_l_per_h = 0;
  problem.machine.rates.price_per_stop = 0;
  const HeadlandTrial trial = trial_behind_one_pass(problem);
  EXPECT_EQ(most_saved_by_shorter_ends(trial), 0);
  EXPECT_TRUE(ends_worth_shortening(trial).empty());
}

// The whole planner drives half circles between all tracks, and the plan holds.
TEST(PlanField, DrivesNoCirclesForAHandsBreadth) {
  PlanningProblem problem = with_oblique_edge(0.2);
  problem.settings.headlands = 1;
  const Plan plan = plan_field(problem.field, problem.machine, {}, problem.settings, 1);
  EXPECT_LT(longest_between_tracks_m(plan), 1.5 * kHalfCircle_m);
  EXPECT_TRUE(std::ranges::any_of(
      plan.warnings, [](const std::string& warning) { return warning.starts_with("shortened: "); }));
  for (const check::Violation& fault : check::verify(plan).violations) ADD_FAILURE() << fault.what;
}

}  // namespace
}  // namespace tramline
