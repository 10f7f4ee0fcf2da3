#include <gtest/gtest.h>

#include "tramline/planner/pareto/dominance.h"
#include "tramline/planner/pareto/front_marks.h"

namespace tramline {
namespace {

using Indices = std::vector<std::size_t>;

Tally tally(double overlap_m2, double uncovered_m2, int turns, int stops = 0) {
  Tally out;
  out.overlap_m2 = overlap_m2;
  out.uncovered_m2 = uncovered_m2;
  out.turns = turns;
  out.stops = stops;
  return out;
}

Front front(const std::vector<Tally>& tallies) {
  Front out;
  for (const Tally& one : tallies) out.points.push_back({one, {}, {}, cost(out.prices, one)});
  return out;
}

TEST(Dominance, TakesNoWorseInAllAndBetterInOne) {
  EXPECT_TRUE(dominates(tally(1, 1, 1), tally(1, 2, 1)));
  EXPECT_FALSE(dominates(tally(1, 1, 1), tally(1, 1, 1)));
  EXPECT_FALSE(dominates(tally(1, 1, 2), tally(1, 2, 1)));
}

// A stop costs more than a turn to one, and nothing to another.
TEST(Dominance, TellsTurnsFromStops) {
  EXPECT_FALSE(dominates(tally(1, 1, 3, 2), tally(1, 1, 4, 1)));
  EXPECT_FALSE(dominates(tally(1, 1, 4, 1), tally(1, 1, 3, 2)));
}

TEST(Dominance, TakesWhatIsBelowAThousandthForRounding) {
  EXPECT_TRUE(dominates(tally(-3e-5, 1, 1), tally(-4e-5, 2, 1)));
  EXPECT_FALSE(dominates(tally(2e-3, 1, 1), tally(0, 2, 1)));
}

// 1 is dominated by 0 and by 4, 3 is 2 again; 5 has a turn less than 0 and a stop more.
TEST(Undominated, AreKeptInOrderAndOnce) {
  const std::vector<Tally> tallies{tally(0, 10, 5), tally(1, 10, 5), tally(5, 0, 9),
                                   tally(5, 0, 9),  tally(1, 9, 5),  tally(0, 10, 4, 1)};
  EXPECT_EQ(undominated(tallies), (Indices{5, 0, 4, 2}));
  EXPECT_EQ(undominated({}), Indices{});
}

// At 1 per m²: 200, 110, 102. At 10 and 1: 200, 560, 1002. At 3 and 2: 400, 270, 304.
TEST(CheapestFor, FollowsThePrices) {
  const Front some = front({tally(0, 200, 0), tally(50, 60, 0), tally(100, 2, 0)});
  EXPECT_EQ(cheapest_for(some, {1, 1, 1, 1}), 2u);
  EXPECT_EQ(cheapest_for(some, {1, 10, 1, 1}), 2u);
  EXPECT_EQ(cheapest_for(some, {10, 1, 1, 1}), 0u);
  EXPECT_EQ(cheapest_for(some, {3, 2, 1, 1}), 1u);
}

// All numbers go from 0 to 100. The extremes are 0, 4 and 5; their plane is x/2 + y/2 + z = 1 (z: turns). 2
// lies at 0.7 and 1 at 0.8, though 1 is nearer to the origin.
TEST(Knee, IsFarthestFromThePlaneOfTheExtremes) {
  Front some = front({tally(0, 100, 50), tally(40, 40, 40), tally(60, 60, 10), tally(90, 90, 100),
                      tally(100, 0, 50), tally(100, 100, 0)});
  some.marks = marks_for(some);
  EXPECT_EQ(some.marks.least_overlap, 0u);
  EXPECT_EQ(some.marks.least_uncovered, 4u);
  EXPECT_EQ(some.marks.fewest_turns, 5u);
  EXPECT_EQ(some.marks.knee, 2u);
}

// One plan is the least in two numbers, so there is no plane: scaled, the points lie at 1, 0.5 and 1.
TEST(Knee, IsNearestToTheOriginWhereThereIsNoPlane) {
  const Front some = front({tally(0, 100, 7), tally(50, 50, 7), tally(100, 0, 7)});
  EXPECT_EQ(marks_for(some).knee, 1u);
}

TEST(Knee, OfOnePlanIsThatPlan) {
  const FrontMarks marks = marks_for(front({tally(3, 4, 5)}));
  EXPECT_EQ(marks.knee, 0u);
  EXPECT_EQ(marks.given_prices, 0u);
}

// 1 and 4 stops count with the turns: 11 and 12.
TEST(Marks, CountStopsWithTurnsAndTakeTheCheaperOfEquals) {
  const FrontMarks marks = marks_for(front({tally(0, 50, 10, 1), tally(0, 40, 8, 4), tally(9, 9, 20)}));
  EXPECT_EQ(marks.fewest_turns, 0u);
  // 50 m² · 0.10 + 10 · 0.45 + 5 = 14.5 is less than 4 + 3.6 + 20.
  EXPECT_EQ(marks.least_overlap, 0u);
  EXPECT_EQ(marks.least_uncovered, 2u);
}

TEST(PointsToShow, LeaveOutWhatIsMuchLikeOneShown) {
  Front some = front({tally(0, 100, 7), tally(1, 99, 7), tally(50, 50, 7), tally(100, 0, 7)});
  some.marks = marks_for(some);
  EXPECT_EQ(points_to_show(some, 0.05), (Indices{0, 2, 3}));
  EXPECT_EQ(points_to_show(some, 0.001), (Indices{0, 1, 2, 3}));
}

}  // namespace
}  // namespace tramline
