// What is true of every repair, on random fields with random gaps.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "support/refusals.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"
#include "tramline/headland/body.h"
#include "tramline/planner/repair/repair_plan.h"

namespace tramline {
namespace {

using testing::base_seed;
using testing::case_count;
using testing::for_each_seed;
using testing::random_field;

constexpr double kMinArea_m2 = 2;

struct Missed {
  Field field;
  Region missed;
  std::vector<Gap> gaps;
  std::vector<DrivenLine> driven;  ///< all over the field, in one direction
};

double pick(std::mt19937_64& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// Turned rectangles, thin ones among them, as far as they lie in the field.
Missed random_missed(std::mt19937_64& random) {
  Missed out;
  out.field = random_field(random, 2);
  const Box box = bounds(out.field.outer);
  Region spots;
  for (int i = 0; i < 6; ++i) {
    const Point at{pick(random, box.min_x, box.max_x), pick(random, box.min_y, box.max_y)};
    const double angle = pick(random, 0, std::numbers::pi);
    const Point along = pick(random, 2, 40) * Point{std::cos(angle), std::sin(angle)};
    const Point across =
        (i % 2 == 0 ? pick(random, 0.2, 2) : pick(random, 2, 20)) * Point{-std::sin(angle), std::cos(angle)};
    spots.push_back({{at, at + along, at + along + across, at + across}, {}});
  }
  out.missed = intersection(unite(spots), body_of(out.field));
  for (const Polygon& polygon : out.missed)
    out.gaps.push_back(
        {static_cast<int>(out.gaps.size()) + 1, polygon, area(polygon), interior_point(polygon), 0});
  const double angle = pick(random, 0, std::numbers::pi), far_m = std::hypot(box.width(), box.height());
  const Point along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
  for (double at = -far_m; at < far_m; at += 5) {
    const Point middle = box.centre() + at * across;
    out.driven.push_back({0, {middle - far_m * along, middle + far_m * along}, 0, 0});
  }
  return out;
}

std::optional<RepairPlan> try_repair(const Missed& missed, double width_m, int threads = 1) {
  RepairTerms terms;
  terms.machine.width_m = width_m;
  terms.objective = {0.02, 0.10, 1, 5};
  return testing_support::unless_refused([&] {
    return repair_plan(missed.field, missed.gaps, missed.missed, missed.driven, terms, kMinArea_m2, threads,
                       {});
  });
}

class RepairProperties : public ::testing::Test {
 protected:
  template <class Property>
  void for_random_repairs(int standard, Property property) {
    int planned = 0;
    for_each_seed(standard, [&](std::mt19937_64& random, int) {
      const Missed missed = random_missed(random);
      const double width_m = pick(random, 3, 12);
      const std::optional<RepairPlan> repair = try_repair(missed, width_m);
      if (!repair) return;
      ++planned;
      property(missed, *repair, width_m);
    });
    EXPECT_GE(3 * planned, case_count(standard)) << "too few of the fields could be repaired";
  }
};

TEST_F(RepairProperties, CheckHoldsAndTheIdentityToo) {
  for_random_repairs(20, [](const Missed& missed, const RepairPlan& repair, double) {
    const check::Verdict verdict = check::verify(repair.plan);
    for (const check::Violation& violation : verdict.violations)
      ADD_FAILURE() << name(violation.rule) << ": " << violation.what;
    EXPECT_NEAR(identity_error_m2(repair.plan), 0, 1e-3);
    EXPECT_NEAR(area(repair.plan.body) + area(repair.plan.worked), area(body_of(missed.field)), 0.05);
  });
}

TEST_F(RepairProperties, EveryGapIsTakenOrListed) {
  for_random_repairs(20, [](const Missed& missed, const RepairPlan& repair, double) {
    EXPECT_EQ(repair.gaps, static_cast<int>(missed.gaps.size()));
    const std::size_t left = repair.ignored.size() + repair.unreachable.size() + repair.not_worth.size();
    EXPECT_EQ(repair.worked_gaps + static_cast<int>(left), repair.gaps);
  });
}

// Of all missed ground, what no swath covers is found by polygons; with the passes it costs less than all of
// it left as it is, and leaving out any piece with those of its line does not cost less.
TEST_F(RepairProperties, EveryPassWinsBackMoreThanItCosts) {
  for_random_repairs(20, [](const Missed& missed, const RepairPlan& repair, double width_m) {
    const Objective& prices = repair.plan.objective;
    const auto cost_of = [&](const std::vector<TrackPiece>& pieces) {
      Region swaths;
      double worked_m2 = 0, stops = 0, turns = 0;
      for (const TrackPiece& piece : pieces) {
        swaths.push_back(oriented({swath(piece, width_m), {}}));
        worked_m2 += width_m * length(piece);
        stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
        turns += piece.after_crossing ? 0 : 1;
      }
      double left_m2 = area(missed.missed);
      if (!swaths.empty()) left_m2 = area(difference(missed.missed, unite(swaths)));
      return prices.uncovered * left_m2 + prices.overlap * (worked_m2 - (area(missed.missed) - left_m2)) +
             prices.stop * stops + prices.turn * turns;
    };
    const std::vector<TrackPiece>& pieces = repair.plan.pieces;
    const double cost = cost_of(pieces);
    EXPECT_LT(cost, repair.cost_if_left);
    EXPECT_LE(cost, repair.cost_after + 1e-3) << "small gaps may be covered by chance";
    for (std::size_t first = 0, last = 1; first < pieces.size(); first = last++) {
      while (last < pieces.size() && pieces[last].after_crossing) ++last;
      std::vector<TrackPiece> fewer(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first));
      fewer.insert(fewer.end(), pieces.begin() + static_cast<std::ptrdiff_t>(last), pieces.end());
      EXPECT_GE(cost_of(fewer), cost - 1e-3) << "without the line of piece " << first + 1;
    }
  });
}

// What is said of a gap that is left is a reason to leave it.
TEST_F(RepairProperties, NoGapIsLeftThatIsSaidToBeWorthAPass) {
  for_random_repairs(20, [](const Missed&, const RepairPlan& repair, double) {
    for (const UnworkedGap& gap : repair.not_worth) {
      double worked_m2 = 0, costs = 0, wins = 0;
      ASSERT_EQ(std::sscanf(gap.why.c_str(),
                            "a pass over %lf m² of it costs %lf with the turn to it and wins back %lf",
                            &worked_m2, &costs, &wins),
                3)
          << gap.why;
      EXPECT_GE(costs, wins) << gap.number;
    }
  });
}

TEST_F(RepairProperties, TheNumberOfThreadsChangesNothing) {
  for_random_repairs(10, [](const Missed& missed, const RepairPlan& repair, double width_m) {
    const std::optional<RepairPlan> other = try_repair(missed, width_m, 4);
    ASSERT_TRUE(other);
    ASSERT_EQ(other->plan.pieces.size(), repair.plan.pieces.size());
    for (std::size_t i = 0; i < repair.plan.pieces.size(); ++i) {
      EXPECT_EQ(other->plan.pieces[i].start, repair.plan.pieces[i].start);
      EXPECT_EQ(other->plan.pieces[i].end, repair.plan.pieces[i].end);
    }
    EXPECT_EQ(other->plan.cost, repair.plan.cost);
  });
}

}  // namespace
}  // namespace tramline
