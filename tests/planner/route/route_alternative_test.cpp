// What is told of plans that were compared: of plans alike the first alone.

#include "tramline/planner/whole/route_alternative.h"

#include <gtest/gtest.h>

#include <vector>

namespace tramline {
namespace {

RouteAlternative towards(const std::vector<double>& degrees, double time_s) {
  RouteAlternative out;
  for (const double one : degrees)
    out.directions.push_back(Direction::clockwise_from_north(Angle::degrees(one)));
  out.cost.working_s = time_s;
  return out;
}

std::vector<double> times_of(const std::vector<RouteAlternative>& all) {
  std::vector<double> out;
  for (const RouteAlternative& one : all) out.push_back(one.cost.working_s);
  return out;
}

TEST(WithoutAlike, OfNearDirectionsTheFirstIsTold) {
  const auto told = without_alike({towards({60}, 1), towards({64}, 2), towards({66}, 3), towards({57}, 4)});
  EXPECT_EQ(times_of(told), (std::vector<double>{1, 3}));
}

TEST(WithoutAlike, DirectionsJustEitherSideOfNorthAreNear) {
  EXPECT_EQ(times_of(without_alike({towards({179}, 1), towards({2}, 2)})), (std::vector<double>{1}));
}

TEST(WithoutAlike, SubfieldsInOtherDirectionsAreAnotherPlan) {
  const auto told = without_alike(
      {towards({10, 90}, 1), towards({10}, 2), towards({90, 12}, 3), towards({10, 50}, 4), towards({}, 5)});
  EXPECT_EQ(times_of(told), (std::vector<double>{1, 2, 4, 5}));
}

TEST(WithoutAlike, OtherPassesOrAnotherKindAreAnotherPlan) {
  RouteAlternative deeper = towards({60}, 2), open = towards({60}, 3), side = towards({60}, 4);
  deeper.headlands = 2;
  open.all_round = false;
  side.kind = Alternative::kLongestSide;
  EXPECT_EQ(times_of(without_alike({towards({60}, 1), deeper, open, side})),
            (std::vector<double>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace tramline
