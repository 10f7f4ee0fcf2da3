#include "tramline/planner/search_context.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tramline/check/verify.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

struct Stop {};

std::string rules_broken(const Plan& plan) {
  std::string out;
  for (const check::Violation& violation : check::verify(plan).violations) out += violation.what + "; ";
  return out;
}

/// A wavy disc some 1200 m across: seconds of search.
Field wavy_field() {
  Field field;
  field.id = "wavy";
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * std::numbers::pi * i / 200;
    const double radius = 600 + 30 * std::sin(13 * angle);
    field.outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return field;
}

// Long after the last direction has been counted a search goes on, and is stopped all the same.
TEST(SearchContext, AProgressThatThrowsEndsASearchWhereverItIs) {
  const Field field = wavy_field();
  Machine machine;
  machine.width_m = 3;
  for (const int threads : {1, 4}) {
    bool counted = false;
    std::chrono::steady_clock::time_point thrown;
    const Progress progress = [&](int done, int total) {
      if (done < total || total == 0) return Demand::kGoOn;
      if (counted) {
        thrown = std::chrono::steady_clock::now();
        throw Stop();
      }
      counted = true;
      return Demand::kGoOn;
    };
    EXPECT_THROW(plan_field(field, machine, {}, {}, threads, progress), Stop);
    EXPECT_TRUE(counted);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - thrown).count(), 1);
  }
}

TEST(SearchContext, AWholePlanIsToldInThousandthsOfWhichNoneIsTakenBack) {
  Machine machine;
  machine.width_m = 6;
  machine.radius_m = 6;
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.aim = Aim::kWholeCost;
  settings.headland_rule = HeadlandRule::kTurns;
  settings.boundary = EdgeKind::kHard;
  int last = 0, steps = 0;
  const Progress progress = [&](int done, int total) {
    if (total == 0) return Demand::kGoOn;  // nothing is known yet
    EXPECT_EQ(total, 1000);
    EXPECT_GE(done, last);
    EXPECT_LE(done, total);
    steps += done > last ? 1 : 0;
    last = done;
    return Demand::kGoOn;
  };
  Field field = wavy_field();
  for (Point& p : field.outer) p = 0.2 * p;
  plan_field(field, machine, {}, settings, 1, progress);
  EXPECT_GT(last, 800) << "all steps but the last are behind it";
  EXPECT_GT(steps, 3) << "it is told while it goes on";
}

TEST(SearchContext, AComparisonIsStoppedWithinItsFirstSearch) {
  Machine machine;
  machine.width_m = 3;
  int calls = 0;
  EXPECT_THROW(trade_off(wavy_field(), machine, {}, {}, 1,
                         [&](int done, int) {
                           EXPECT_EQ(done, 0);
                           if (++calls == 3) throw Stop();
                           return Demand::kGoOn;
                         }),
               Stop);
}

TEST(SearchContext, AProgressChangesNoPlan) {
  Field field = wavy_field();
  for (Point& p : field.outer) p = 0.2 * p;
  const Plan without = plan_field(field, {}, {}, {});
  const Plan with = plan_field(field, {}, {}, {}, 0, [](int, int) { return Demand::kGoOn; });
  EXPECT_EQ(without.cost, with.cost);
  ASSERT_EQ(without.pieces.size(), with.pieces.size());
  for (std::size_t i = 0; i < with.pieces.size(); ++i) {
    EXPECT_EQ(without.pieces[i].start, with.pieces[i].start);
    EXPECT_EQ(without.pieces[i].end, with.pieces[i].end);
  }
}

TEST(SearchEnd, GivesThePlanFoundTillThenAndSaysSo) {
  const Field field = wavy_field();
  Machine machine;
  machine.width_m = 3;
  for (const int threads : {1, 4}) {
    std::atomic<int> calls = 0;
    const Plan early = plan_field(field, machine, {}, {}, threads,
                                  [&](int, int) { return ++calls >= 3 ? Demand::kEnd : Demand::kGoOn; });
    EXPECT_TRUE(early.proof.cut_short);
    ASSERT_FALSE(early.warnings.empty());
    EXPECT_EQ(early.warnings.front().find("the search was ended"), 0u);
    EXPECT_EQ(rules_broken(early), "");
    EXPECT_LE(early.proof.bound, early.cost);
    EXPECT_LE(early.proof.one_direction_bound, early.proof.one_direction_cost);
  }
}

// From its first moment on: one direction is tried all the same, as nothing is no plan.
TEST(SearchEnd, ComesWithAPlanHoweverSoonItIsWanted) {
  Field field = wavy_field();
  for (Point& p : field.outer) p = 0.2 * p;
  const Progress at_once = [](int, int) { return Demand::kEnd; };
  const Plan whole = plan_field(field, {}, {}, {});
  EXPECT_FALSE(whole.proof.cut_short);
  for (const TrackShape shape : {TrackShape::kStraight, TrackShape::kCurved, TrackShape::kAuto}) {
    PlanSettings settings;
    settings.shape = shape;
    settings.headlands = 1;
    const Plan early = plan_field(field, {}, {}, settings, 0, at_once);
    EXPECT_TRUE(early.proof.cut_short);
    EXPECT_FALSE(early.pieces.empty());
    EXPECT_EQ(rules_broken(early), "");
  }
  const TradeOff few = trade_off(field, {}, {}, {}, 0, at_once);
  EXPECT_TRUE(few.cut_short);
  EXPECT_TRUE(given_plan(few).proof.cut_short);
  // No bound of a search that has hardly begun is above what a whole one has found.
  EXPECT_LE(plan_field(field, {}, {}, {}, 0, at_once).proof.bound, whole.cost);
}

TEST(SearchContext, ReportsFromTheThreadsThatWorkForIt) {
  std::atomic<int> calls = 0;
  const Progress progress = [&](int, int) {
    ++calls;
    return Demand::kGoOn;
  };
  const SearchContext context(2, progress);
  for_each_index(4, context, [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(30)); });
  EXPECT_GE(calls, 2);
  const int before = calls;
  for_each_index(100, context, [](std::size_t) {});
  EXPECT_LE(calls, before + 1) << "no more than some fifty times a second";
}

TEST(SearchContext, OfASearchWithinCountsForNobodyAndReportsForAll) {
  std::vector<std::pair<int, int>> told;
  const SearchContext context(1, [&](int done, int total) {
    told.emplace_back(done, total);
    return Demand::kEnd;
  });
  context.count(1, 2);
  const SearchContext within = context.uncounted().on_one_thread();
  within.count(7, 8);
  ASSERT_FALSE(context.cut_short());
  EXPECT_TRUE(within.has_to_end());
  EXPECT_TRUE(context.cut_short());
  EXPECT_EQ(told, (std::vector<std::pair<int, int>>(2, {1, 2})));
}

TEST(SearchContext, WithoutAProgressGoesOn) {
  const SearchContext context(3);
  EXPECT_EQ(context.threads(), 3);
  context.count(1, 2);
  context.report();
  EXPECT_FALSE(context.has_to_end());
  EXPECT_FALSE(context.cut_short());
}

}  // namespace
}  // namespace tramline
