// Fields hardly larger than the machine, for which few plans do.

#include <gtest/gtest.h>

#include <iostream>
#include <optional>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/model/rate_values.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using testing::for_each_seed;

Machine wide_machine() {
  Machine out;
  out.width_m = 24;
  out.radius_m = 8;
  return out;
}

/// From half a hectare to a whole one, with four sides.
Field small_field(std::mt19937_64& random) {
  const double wide_m = uniform(random, 45, 120), long_m = uniform(random, 40, 90);
  const double skew_m = uniform(random, -20, 20);
  Field out;
  out.id = "small";
  out.outer = {{0, 0}, {wide_m, 0}, {wide_m + skew_m, long_m}, {0.5 * skew_m, 0.9 * long_m}};
  return out;
}

/// By default, or with so many passes round the field; nullopt where there is no room for any plan.
std::optional<double> euros_of(const Field& field, std::optional<int> passes) {
  PlanSettings settings;
  settings.boundary = EdgeKind::kHard;
  settings.turns = TurnPlanning::kRoute;
  settings.aim = Aim::kWholeCost;
  settings.shape = TrackShape::kAuto;
  settings.headland_rule = passes ? HeadlandRule::kPasses : HeadlandRule::kTurns;
  settings.headlands = passes.value_or(0);
  try {
    return whole_cost(plan_field(field, wide_machine(), Objective{}, settings)).euros();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    return std::nullopt;
  }
}

// What is chosen freely costs no more than what is asked for, but for the steps of searches.
TEST(SmallFields, CostNoMoreThanWithHeadlandsAskedFor) {
  int dearer = 0;
  for_each_seed(25, [&](std::mt19937_64& random, int) {
    const Field field = small_field(random);
    const std::optional<double> free = euros_of(field, std::nullopt);
    for (const int passes : {0, 1, 2}) {
      const std::optional<double> asked = euros_of(field, passes);
      if (!asked) continue;
      ASSERT_TRUE(free);
      EXPECT_LE(*free, 1.02 * *asked) << passes;
      if (*asked > 1.1 * *free) ++dearer;
    }
  });
  std::cout << dearer << " headlands asked for cost a tenth more\n";
  if (testing::case_count(25) >= 25) {
    EXPECT_GT(dearer, 0);
  }
}

}  // namespace
}  // namespace tramline
