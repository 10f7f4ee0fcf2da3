// A proof by prices of the land that has been tampered with, and one that holds. The field is a rectangle of
// 120 m x 24 m, 6 m wide swaths: four tracks along it, each worth 120 · 6 = 720 m². With a turn at 1 a price
// of 1/(6 · L) is right for no piece longer than L, and none is longer than the diagonal of 122.4 m; the
// cells are strips of 20 m x 24 m.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/box_ring.h"
#include "tramline/check/rules/rules.h"

namespace tramline::check {
namespace {

constexpr double kLength_m = 120, kAcross_m = 24, kWidth_m = 6, kCell_m = 20;
/// Longer than any piece that lies within the land, also where a check looks a metre beyond its ends.
constexpr double kLongest_m = 128;

using testing_support::box;

Plan proven_plan() {
  Plan plan;
  plan.field.id = "strip";
  plan.field.outer = box(0, 0, kLength_m, kAcross_m);
  plan.body = {{plan.field.outer, {}}};
  plan.machine.width_m = kWidth_m;
  plan.machine.radius_m = 6;
  plan.objective = {0.02, 0.1, 1, 5, 5};
  const double price = 1 / (kWidth_m * kLongest_m);
  for (int i = 0; i < 6; ++i)
    plan.proof.prices.cells.push_back({box(i * kCell_m, 0, (i + 1) * kCell_m, kAcross_m), price});
  plan.proof.prices.bound = price * kLength_m * kAcross_m - 1;
  return plan;
}

std::vector<std::string> faults(const Plan& plan) {
  Violations found;
  check_prices(plan, found);
  std::vector<std::string> out;
  for (const Violation& violation : found) {
    EXPECT_EQ(violation.rule, Rule::kProof);
    out.push_back(violation.what);
  }
  return out;
}

bool has(const std::vector<std::string>& all, const char* words) {
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

TEST(Prices, AProofThatIsTrueHolds) { EXPECT_EQ(faults(proven_plan()), std::vector<std::string>{}); }

TEST(Prices, APlanWithoutPricesClaimsNothing) {
  Plan plan = proven_plan();
  plan.proof.prices = {};
  EXPECT_EQ(faults(plan), std::vector<std::string>{});
}

// A track along the field works 120 m² of a cell: 0.01 more per m² makes 1.2 more than its turn.
TEST(Prices, ARaisedPriceOfOneCellIsFound) {
  Plan plan = proven_plan();
  plan.proof.prices.cells[2].price += 0.01;
  EXPECT_TRUE(has(faults(plan), "more than its turn"));
}

// 8 % more on all of them is worth 120/128 · 1.08 = 1.0125 of a turn along the field.
TEST(Prices, PricesThatAreALittleTooHighAreFound) {
  Plan plan = proven_plan();
  for (GroundPrices::Cell& cell : plan.proof.prices.cells) cell.price *= 1.08;
  EXPECT_TRUE(has(faults(plan), "more than its turn"));
}

TEST(Prices, AMovedCellIsFound) {
  Plan plan = proven_plan();
  for (Point& corner : plan.proof.prices.cells[2].shape) corner.x += 1;
  EXPECT_TRUE(has(faults(plan), "in common"));
  // Off the land it lies on no other cell, and its land is missing in the sum.
  plan = proven_plan();
  for (Point& corner : plan.proof.prices.cells[2].shape) corner.y += 2 * kAcross_m;
  EXPECT_TRUE(has(faults(plan), "prove that no plan costs less"));
}

TEST(Prices, AMissingCellIsFound) {
  Plan plan = proven_plan();
  plan.proof.prices.cells.erase(plan.proof.prices.cells.begin() + 3);
  EXPECT_TRUE(has(faults(plan), "prove that no plan costs less"));
}

TEST(Prices, ALostLayerIsFound) {
  Plan plan = proven_plan();
  plan.proof.prices.cells.clear();
  EXPECT_TRUE(has(faults(plan), "no prices of the land"));
}

TEST(Prices, ARaisedBoundIsFound) {
  Plan plan = proven_plan();
  plan.proof.prices.bound += 0.001;
  EXPECT_TRUE(has(faults(plan), "prove that no plan costs less"));
}

// What a piece costs has been lowered after the proof was made.
TEST(Prices, ACheaperTurnIsFound) {
  Plan plan = proven_plan();
  plan.objective.turn = 0.9;
  EXPECT_TRUE(has(faults(plan), "more than its turn"));
}

TEST(Prices, CheaperUncoveredLandIsFound) {
  Plan plan = proven_plan();
  plan.objective.uncovered = 0.001;
  EXPECT_TRUE(has(faults(plan), "that of uncovered land"));
}

TEST(Prices, AWiderMachineIsFound) {
  Plan plan = proven_plan();
  plan.machine.width_m = 7;
  EXPECT_TRUE(has(faults(plan), "more than its turn"));
}

TEST(Prices, BrokenCellsAreFound) {
  Plan plan = proven_plan();
  std::swap(plan.proof.prices.cells[0].shape[0], plan.proof.prices.cells[0].shape[1]);
  EXPECT_TRUE(has(faults(plan), "is not convex"));
  plan = proven_plan();
  plan.proof.prices.cells[0].price = std::nan("");
  EXPECT_TRUE(has(faults(plan), "the price of a cell"));
  plan = proven_plan();
  plan.proof.prices.cells[0].price = -0.001;
  EXPECT_TRUE(has(faults(plan), "the price of a cell"));
}

// Overlap that costs nothing lets a piece lie half beyond the land, but it is worth no more for that.
TEST(Prices, FreeOverlapChangesNothingWithinOneTrack) {
  Plan plan = proven_plan();
  plan.objective.overlap = 0;
  EXPECT_EQ(faults(plan), std::vector<std::string>{});
}

// A pole of 1 m in the middle. A detour may be displaced by h = 1.01 + 6 m, and is then longer than its rows
// by 2h·√(h/(4r − h)) = 9 m at most, r = 6 m: 129 m, and the price is right for no more than 128 m.
TEST(Prices, DetoursRoundAnObstacleAreCounted) {
  Plan plan = proven_plan();
  const Ring pole = box(60, 11, 61, 12);
  plan.field.obstacles.push_back({{pole, {}}, ObstacleKind::kObstacle, "pole"});
  plan.body = {{plan.field.outer, {{{60, 11}, {60, 12}, {61, 12}, {61, 11}}}}};
  const double price = plan.proof.prices.cells.front().price;
  plan.proof.prices.bound -= price;
  EXPECT_TRUE(has(faults(plan), "more than its turn"));
  // It is right again for 180 m, which no piece is long.
  for (GroundPrices::Cell& cell : plan.proof.prices.cells) cell.price *= 120.0 / (120 + 60);
  plan.proof.prices.bound = (plan.proof.prices.bound + 1) * 120 / (120 + 60) - 1;
  EXPECT_EQ(faults(plan), std::vector<std::string>{});
}

}  // namespace
}  // namespace tramline::check
