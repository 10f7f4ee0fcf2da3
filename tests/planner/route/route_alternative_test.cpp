// What is told of plans that were compared: in order of their costs, what is planned first, of plans alike
// the first alone.

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
  out.cost.hours = time_s / 3600;
  return out;
}

std::vector<double> times_of(const std::vector<RouteAlternative>& all) {
  std::vector<double> out;
  for (const RouteAlternative& one : all) out.push_back(one.cost.working_s);
  return out;
}

/// No plan of these is planned.
std::vector<RouteAlternative> told_of(std::vector<RouteAlternative> all) {
  return in_order_told(std::move(all), Plan{});
}

TEST(InOrderTold, TheCheaperIsToldBefore) {
  EXPECT_EQ(times_of(told_of({towards({60}, 3), towards({90}, 1), towards({120}, 2)})),
            (std::vector<double>{1, 2, 3}));
}

TEST(InOrderTold, WhatIsPlannedComesFirstThoughAnotherCostsLess) {
  Plan planned;
  RouteLeg leg;
  leg.time_s = 3600;
  planned.route.legs.push_back(leg);
  const RouteAlternative of_it = alternative_of(Alternative::kAdjacent, planned);
  RouteAlternative dearer = of_it, cheaper = of_it;
  dearer.kind = Alternative::kUndivided;
  dearer.cost.hours += 1;
  cheaper.kind = Alternative::kSearched;
  cheaper.cost.hours -= 1;
  std::vector<Alternative> kinds;
  for (const RouteAlternative& one : in_order_told({dearer, cheaper, of_it}, planned))
    kinds.push_back(one.kind);
  EXPECT_EQ(kinds, (std::vector<Alternative>{Alternative::kAdjacent, Alternative::kSearched,
                                             Alternative::kUndivided}));
}

TEST(InOrderTold, OfNearDirectionsTheFirstIsTold) {
  const auto told = told_of({towards({60}, 1), towards({64}, 2), towards({66}, 3), towards({57}, 4)});
  EXPECT_EQ(times_of(told), (std::vector<double>{1, 3}));
}

TEST(InOrderTold, DirectionsJustEitherSideOfNorthAreNear) {
  EXPECT_EQ(times_of(told_of({towards({179}, 1), towards({2}, 2)})), (std::vector<double>{1}));
}

TEST(InOrderTold, SubfieldsInOtherDirectionsAreAnotherPlan) {
  const auto told = told_of(
      {towards({10, 90}, 1), towards({10}, 2), towards({90, 12}, 3), towards({10, 50}, 4), towards({}, 5)});
  EXPECT_EQ(times_of(told), (std::vector<double>{1, 2, 4, 5}));
}

TEST(InOrderTold, OtherPassesOrAnotherKindAreAnotherPlan) {
  RouteAlternative deeper = towards({60}, 2), open = towards({60}, 3), side = towards({60}, 4);
  deeper.headlands = 2;
  open.all_round = false;
  side.kind = Alternative::kLongestSide;
  EXPECT_EQ(times_of(told_of({towards({60}, 1), deeper, open, side})), (std::vector<double>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace tramline
