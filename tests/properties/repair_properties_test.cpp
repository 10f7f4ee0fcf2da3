// What is true of every repair, on random fields with random gaps.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/interior_point.h"
#include "tramline/headland/body.h"
#include "tramline/planner/repair_plan.h"

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
  return out;
}

std::optional<RepairPlan> try_repair(const Missed& missed, double width_m, int threads = 1) {
  RepairTerms terms;
  terms.machine.width_m = width_m;
  try {
    return repair_plan(missed.field, missed.gaps, missed.missed, terms, kMinArea_m2, threads, {});
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// By polygons: the most of `ground` that a swath in this place works, over every stretch at least w long on
/// which it keeps within `free`.
double most_worked_m2(Point middle, Point along, double width_m, const Region& free, const Polygon& ground) {
  constexpr double kFar_m = 2000;
  const Point across = Point{-along.y, along.x};
  const auto rectangle = [&](double from, double to) {
    const Point a = middle + from * along, b = middle + to * along, half = 0.5 * width_m * across;
    return Region{{{a - half, b - half, b + half, a + half}, {}}};
  };
  // Rectangles turned by a right angle: oriented() sees to their sense.
  const auto sound = [](Region region) {
    for (Polygon& polygon : region) polygon = oriented(std::move(polygon));
    return region;
  };
  double most = 0, from = -kFar_m;
  std::vector<std::pair<double, double>> blocked;
  for (const Polygon& part : difference(sound(rectangle(-kFar_m, kFar_m)), free)) {
    double low = kFar_m, high = -kFar_m;
    for (const Point p : part.outer) {
      low = std::min(low, dot(p - middle, along));
      high = std::max(high, dot(p - middle, along));
    }
    if (area(part) > 1e-3) blocked.emplace_back(low, high);
  }
  std::sort(blocked.begin(), blocked.end());
  blocked.emplace_back(kFar_m, kFar_m);
  for (const auto& [low, high] : blocked) {
    if (low - from >= width_m)
      most = std::max(most, area(intersection(sound(rectangle(from, low)), {ground})));
    from = std::max(from, high);
  }
  return most;
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
  for_random_repairs(40, [](const Missed& missed, const RepairPlan& repair, double) {
    const check::Verdict verdict = check::verify(repair.plan);
    for (const check::Violation& violation : verdict.violations)
      ADD_FAILURE() << violation.rule << ": " << violation.what;
    EXPECT_NEAR(identity_error_m2(repair.plan), 0, 1e-3);
    EXPECT_NEAR(area(repair.plan.body) + area(repair.plan.worked), area(body_of(missed.field)), 0.05);
  });
}

TEST_F(RepairProperties, EveryGapIsTakenIgnoredOrListed) {
  for_random_repairs(40, [](const Missed& missed, const RepairPlan& repair, double) {
    int whole = 0;
    for (const LeftGap& left : repair.unreachable) whole += left.why.starts_with("part of") ? 0 : 1;
    EXPECT_EQ(repair.gaps, static_cast<int>(missed.gaps.size()));
    EXPECT_EQ(repair.taken + static_cast<int>(repair.ignored.size()) + whole, repair.gaps);
  });
}

// What is left of at least the least area is listed, and no swath in any of 36 directions and 20 places
// across works twice the least area of it. (Twice: directions and places of the search are others.)
TEST_F(RepairProperties, NothingIsLeftThatASwathCouldWork) {
  for_random_repairs(25, [](const Missed& missed, const RepairPlan& repair, double width_m) {
    const Region free = body_of(missed.field);
    double listed_m2 = 0, left_m2 = 0;
    for (const LeftGap& left : repair.unreachable) listed_m2 += left.area_m2;
    for (const Polygon& left : difference(missed.missed, unite(swaths(repair.plan)))) {
      if (area(left) < 1.001 * kMinArea_m2) continue;
      left_m2 += area(left);
      const Box box = bounds(left);
      const double reach_m = 0.5 * (std::hypot(box.width(), box.height()) + width_m);
      for (int i = 0; i < 36; ++i) {
        const double angle = i * std::numbers::pi / 36;
        const Point along{std::cos(angle), std::sin(angle)};
        for (int k = 0; k <= 20; ++k) {
          const Point at = box.centre() + (reach_m * (k - 10) / 10) * Point{-along.y, along.x};
          ASSERT_LT(most_worked_m2(at, along, width_m, free, left), 2 * kMinArea_m2)
              << "of " << area(left) << " m² at " << box.centre().x << ", " << box.centre().y
              << ", direction " << 5 * i;
        }
      }
    }
    EXPECT_LE(left_m2, listed_m2 + 0.01) << "something was left that is not listed";
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
