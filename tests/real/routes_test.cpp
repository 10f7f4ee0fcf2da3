// Headlands as turns need them, with the whole route, on real fields: narrow arms, land left to tracks beside
// passes along single edges, circles and islands. All fields and machines are the business of route_real.

#include <gtest/gtest.h>

#include <string>

#include "real/real_fields.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

struct Example {
  std::string id;
  double width_m, radius_m;
  bool reverses;
};

Machine machine_of(const Example& one) {
  Machine out;
  out.width_m = one.width_m;
  out.radius_m = one.radius_m;
  out.turning.reverse = one.reverses;
  return out;
}

/// Arms too narrow for a track by themselves, which tracks work together with headland beside them; then
/// others.
const std::vector<Example> kExamples{{"at-block/57", 6, 6, true}, {"be-vlg/73", 6, 6, true},
                                     {"de-sh/20", 6, 6, true},    {"si/67", 24, 8, false},
                                     {"bg/0", 24, 8, false},      {"br-lem/23", 24, 8, false}};

TEST(RealFields, RoutesOnOddFieldsHold) {
  const auto fields = testing::read_real_fields();
  if (!fields) GTEST_SKIP() << testing::no_real_fields();
  const Crs crs(fields->dataset.layers.front().crs);
  PlanSettings settings;
  settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kTurns;
  settings.turns = TurnPlanning::kRoute;
  for (const Example& one : kExamples) {
    int found = 0;
    for (const RawFeature& feature : fields->features()) {
      if (feature.id != one.id) continue;
      for (const Field& field : testing::admitted(*fields, crs, feature)) {
        const Plan plan = plan_field(field, machine_of(one), {}, settings, 1);
        EXPECT_TRUE(plan.route.planned()) << one.id;
        for (const std::string& fault : testing::faults_of(plan)) ADD_FAILURE() << one.id << ": " << fault;
        ++found;
      }
    }
    EXPECT_GE(found, 1) << one.id;
  }
}

}  // namespace
}  // namespace tramline
