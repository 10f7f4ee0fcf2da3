// The split of a plan's cost by its causes, on random fields and scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "properties/random_field.h"
#include "properties/random_scene.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline::cost_causes_properties_test {

using testing::case_count;
using testing::Scene;

std::optional<ExplainedPlan> try_plan(const Scene& scene) {
  try {
    return plan_and_explain(scene.field, scene.machine, scene.objective, scene.settings, 1);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
    return std::nullopt;
  }
}

/// What the precision grid and the width tolerance may move along every border of ground and strips.
double area_tolerance_m2(const Plan& plan) {
  double borders_m = perimeter(plan.field.outer) + plan.tally.track_length_m;
  for (const Subfield& subfield : plan.subfields)
    for (const Ring& ring : rings_of({subfield.shape})) borders_m += perimeter(ring);
  return 1e-5 * borders_m + 1e-6;
}

void expect_partition(const Plan& plan, const CostCauses& causes) {
  double overlap_m2 = 0, uncovered_m2 = 0, sum = 0;
  for (const CausePart& part : causes.parts) {
    overlap_m2 += part.overlap_m2;
    uncovered_m2 += part.uncovered_m2;
    sum += part.cost;
    EXPECT_GE(part.overlap_m2, -area_tolerance_m2(plan));
    EXPECT_GE(part.uncovered_m2, -area_tolerance_m2(plan));
  }
  const double digits = 1e-12 * (1 + plan.tally.worked_m2);
  EXPECT_NEAR(overlap_m2, plan.tally.overlap_m2, digits);
  EXPECT_NEAR(uncovered_m2, plan.tally.uncovered_m2, digits);
  EXPECT_NEAR(sum, plan.cost,
              digits * (plan.objective.overlap + plan.objective.uncovered) + 1e-12 * plan.cost);
  EXPECT_EQ(causes.of(Cause::kTurns).count, plan.tally.turns);
  EXPECT_EQ(causes.of(Cause::kStops).count, plan.tally.stops);
  // The parts are measured one by one: that they sum to the tally shows that none is missing or met twice.
  EXPECT_NEAR(causes.overlap_rounding_m2, 0, area_tolerance_m2(plan));
  EXPECT_NEAR(causes.uncovered_rounding_m2, 0, area_tolerance_m2(plan));
}

/// The other road: what straight swaths work beyond the field, by polygon booleans.
void expect_overlap_beyond_the_field(const Plan& plan, const CostCauses& causes) {
  double beyond_m2 = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const PathSegment& straight : straight_parts(piece)) {
      const TrackPiece alone{straight.from, straight.to};
      beyond_m2 += area(difference({{swath(alone, plan.machine.width_m), {}}}, {{plan.field.outer, {}}}));
    }
  EXPECT_NEAR(causes.of(Cause::kRowEnds).overlap_m2 + causes.of(Cause::kSides).overlap_m2, beyond_m2,
              area_tolerance_m2(plan));
}

/// Causes that cannot be there have no part, but for what the largest part holds of the rounding.
void expect_no_part_without_cause(const Plan& plan, const CostCauses& causes) {
  const double nothing_m2 = area_tolerance_m2(plan);
  if (plan.subfields.size() < 2) {
    EXPECT_LE(causes.of(Cause::kSeams).overlap_m2, nothing_m2);
    EXPECT_LE(causes.of(Cause::kSeams).uncovered_m2, nothing_m2);
  }
  const bool straight = std::all_of(plan.pieces.begin(), plan.pieces.end(),
                                    [](const TrackPiece& piece) { return piece.detours.empty(); });
  if (straight) {
    EXPECT_LE(causes.of(Cause::kDetours).overlap_m2, nothing_m2);
    EXPECT_LE(causes.of(Cause::kDetours).uncovered_m2, nothing_m2);
  }
  if (plan.dropped.empty()) {
    EXPECT_LE(causes.of(Cause::kShortPieces).uncovered_m2, nothing_m2);
  }
  EXPECT_NEAR(causes.of(Cause::kGivenUp).uncovered_m2, area(plan.given_up), nothing_m2);
  EXPECT_LE(causes.of(Cause::kStops).overlap_m2, nothing_m2);
}

void expect_runner_ups_in_order(const ExplainedPlan& explained) {
  double cost = explained.plan.cost;
  for (const RunnerUp& plan : explained.why->runner_ups) {
    EXPECT_GE(plan.cost, cost - 1e-9 * std::abs(cost));
    EXPECT_GT(plan.tally.pieces, 0);
    cost = plan.cost;
  }
}

bool look_at(const Scene& scene) {
  const std::optional<ExplainedPlan> explained = try_plan(scene);
  if (!explained) return false;
  expect_partition(explained->plan, explained->why->causes);
  expect_overlap_beyond_the_field(explained->plan, explained->why->causes);
  expect_no_part_without_cause(explained->plan, explained->why->causes);
  expect_runner_ups_in_order(*explained);
  return true;
}

template <class MakeScene>
void for_random_scenes(int standard, MakeScene make) {
  int planned = 0;
  const int cases = case_count(standard);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    try {
      planned += look_at(make(random)) ? 1 : 0;
    } catch (const Error& error) {  // a scene without land left is none
      if (error.kind() != ErrorKind::kBadInput) throw;
    }
    if (::testing::Test::HasFailure()) return;
  }
  if (cases < 20) return;  // too few to tell whether scenes are what they should be
  EXPECT_GT(planned, cases / 2);
}

TEST(CostCausesProperties, PartTheTallyOfPlansOverFields) {
  for_random_scenes(8, [](std::mt19937_64& random) {
    Scene scene;
    scene.field = testing::random_field(random, 4);
    scene.settings.end_rule = static_cast<EndRule>(random() % 4);
    scene.settings.boundary = random() % 3 == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
    scene.settings.strategy = random() % 2 == 0 ? Strategy::kSweep : Strategy::kBest;
    return scene;
  });
}

TEST(CostCausesProperties, PartTheTallyOfPlansAmongObstacles) {
  for_random_scenes(25, [](std::mt19937_64& random) {
    Scene scene = testing::random_scene(random);
    scene.settings.strategy = Strategy::kSweep;
    return scene;
  });
}

}  // namespace tramline::cost_causes_properties_test
