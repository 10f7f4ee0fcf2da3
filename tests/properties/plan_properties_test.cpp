// What is true of every plan, on random fields with obstacles.

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "properties/random_field.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using testing::base_seed;
using testing::case_count;
using testing::random_field;

struct Request {
  Machine machine;
  Objective objective;
  PlanSettings settings;
};

Request random_request(std::mt19937_64& random) {
  Request out;
  const auto pick = [&random](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  out.machine.width_m = std::array{2.0, 3.0, 4.5, 6.0}[static_cast<std::size_t>(pick(4))];
  out.objective = std::array{Objective{}, Objective{99999, 1, 1, 0}, Objective{1, 99999, 1, 0},
                             Objective{1, 1, 99999, 0}}[static_cast<std::size_t>(pick(4))];
  out.settings.end_rule = static_cast<EndRule>(pick(4));
  out.settings.boundary = pick(3) == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
  out.settings.merge_threshold = Angle::degrees(pick(2) * 15);
  out.settings.decomposition_threshold = Angle::degrees(180 + 25 * pick(2));
  return out;
}

/// The plan, or nothing where no track fits.
std::optional<Plan> try_plan(const Field& field, const Request& request, int threads = 1) {
  try {
    return plan_field(field, request.machine, request.objective, request.settings, threads);
  } catch (const Error&) {
    return std::nullopt;
  }
}

class PlanProperties : public ::testing::Test {
 protected:
  template <class Property>
  void for_random_fields(int standard, Property property) {
    int planned = 0;
    const int cases = case_count(standard);
    for (int i = 0; i < cases; ++i) {
      const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
      SCOPED_TRACE("seed " + std::to_string(seed) + " (TRAMLINE_SEED=" + std::to_string(seed) + " TRAMLINE_CASES=1)");
      std::mt19937_64 random(seed);
      const Field field = random_field(random, 6);
      const Request request = random_request(random);
      if (property(field, request)) ++planned;
      if (HasFailure()) return;
    }
    EXPECT_GT(planned, cases / 2);
  }
};

/// The other road: the useful area by polygon booleans.
TEST_F(PlanProperties, TallyAgreesWithPolygonBooleans) {
  for_random_fields(150, [](const Field& field, const Request& request) {
    const auto plan = try_plan(field, request);
    if (!plan) return false;
    const double tolerance = 1e-6 * area(Polygon{field.outer, {}});
    double worked = 0;
    for (const Polygon& swath : swaths(*plan)) worked += area(swath);
    const double useful = area(intersection(unite(swaths(*plan)), plan->body));
    EXPECT_NEAR(plan->tally.worked_m2, worked, tolerance);
    EXPECT_NEAR(plan->tally.overlap_m2, worked - useful, tolerance);
    EXPECT_NEAR(plan->tally.uncovered_m2, area(plan->body) - useful, tolerance);
    EXPECT_NEAR(worked, area(plan->body) - plan->tally.uncovered_m2 + plan->tally.overlap_m2, tolerance);
    EXPECT_NEAR(area(plan->uncovered), plan->tally.uncovered_m2, tolerance);
    return true;
  });
}

}  // namespace
}  // namespace tramline
