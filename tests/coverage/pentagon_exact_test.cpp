// The exact engine on the routes over the pentagon of Zhang §3.1.

#include <gtest/gtest.h>

#include "coverage/pentagon_routes.h"
#include "tramline/coverage/evaluate.h"

namespace tramline::coverage {
namespace {

using namespace testing_routes;

// To what the table of the routes is rounded to.
TEST(ExactEngine, TheRoutesOverThePentagonAreAsWorkedOut) {
  EvaluateSettings settings;
  settings.repeat = RepeatRule::kStrict;
  for (const PentagonRoute& route : routes()) {
    SCOPED_TRACE(route.name);
    const Coverage found = evaluate(route.steps, kRouteWidth_m, pentagon(), settings);
    EXPECT_NEAR(found.areas.covered_m2, route.covered_m2, 0.005);
    EXPECT_NEAR(found.areas.repeated_m2, route.repeated_m2, 0.005);
    EXPECT_NEAR(found.areas.missed_m2, route.missed_m2, 0.005);
    EXPECT_NEAR(area(found.covered), route.covered_m2, 0.005);
    EXPECT_NEAR(area(found.repeated), route.repeated_m2, 0.005);
    EXPECT_NEAR(area(found.missed), route.missed_m2, 0.005);
  }
}

// Rows and legs are runs of their own, so there is no trail to tell apart: both ways of counting agree.
TEST(ExactEngine, WithoutCurvesStrictIsTheSame) {
  for (const PentagonRoute& route : routes()) {
    SCOPED_TRACE(route.name);
    const Coverage found = evaluate(route.steps, kRouteWidth_m, pentagon(), {});
    EXPECT_NEAR(found.areas.repeated_m2, route.repeated_m2, 0.005);
    EXPECT_NEAR(found.areas.sliver_m2, 0, 0.005);
  }
}

}  // namespace
}  // namespace tramline::coverage
