// The lines that a repair chooses, against all choices there are on small scenes. Costs are found anew here:
// from polygons, word for word.

#include "tramline/planner/repair/repair_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tramline/planner/repair/line_positions.h"

namespace tramline::repair_choice_test {

constexpr double kWidth_m = 6;

Polygon box(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

/// Some gaps on a field of 80 m, driven north; no two meet.
struct Scene {
  Field field;
  std::vector<Gap> gaps;
  RepairTerms terms;

  RepairGround ground() const {
    DrivenDirections north{{Direction::along({0, 0}, {0, 1})},
                           std::vector<std::vector<std::size_t>>(gaps.size(), {0})};
    return RepairGround(field, gaps, north, terms);
  }
};

Scene scene(std::mt19937_64& random) {
  const auto pick = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  Scene out;
  out.field.id = "square";
  out.field.outer = box(0, 0, 80, 80).outer;
  out.terms.machine.width_m = kWidth_m;
  out.terms.objective = {0.02, 0.10, 1.00, 5};
  // In four quarters, near one another across, so that lines may take several along.
  for (int i = 0; i < 4; ++i) {
    const double low_y = 3 + 20 * i, left = pick(30, 44);
    const Polygon shape = box(left, low_y, left + pick(0.8, 9), low_y + pick(3, 14));
    out.gaps.push_back({i + 1, shape, area(shape), midpoint(shape.outer[0], shape.outer[2]), 0});
  }
  return out;
}

/// What no swath covers of the gaps, m²: all are boxes, so between all their edges the plane is a grid.
double left_of(const std::vector<Box>& gaps, const std::vector<Box>& swaths) {
  std::vector<double> xs, ys;
  for (const std::vector<Box>* boxes : {&gaps, &swaths})
    for (const Box& box : *boxes) {
      xs.insert(xs.end(), {box.min_x, box.max_x});
      ys.insert(ys.end(), {box.min_y, box.max_y});
    }
  std::sort(xs.begin(), xs.end());
  std::sort(ys.begin(), ys.end());
  const auto any = [](const std::vector<Box>& boxes, Point p) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
      return box.min_x < p.x && p.x < box.max_x && box.min_y < p.y && p.y < box.max_y;
    });
  };
  double sum = 0;
  for (std::size_t i = 1; i < xs.size(); ++i)
    for (std::size_t k = 1; k < ys.size(); ++k) {
      const Point middle{0.5 * (xs[i - 1] + xs[i]), 0.5 * (ys[k - 1] + ys[k])};
      if (any(gaps, middle) && !any(swaths, middle)) sum += (xs[i] - xs[i - 1]) * (ys[k] - ys[k - 1]);
    }
  return sum;
}

double cost_of(const Scene& scene, const std::vector<RepairLine>& lines) {
  const Objective& prices = scene.terms.objective;
  std::vector<Box> gaps, swaths;
  double gaps_m2 = 0;
  for (const Gap& gap : scene.gaps) {
    gaps.push_back(bounds(gap.shape));
    gaps_m2 += gap.area_m2;
  }
  double worked_m2 = 0, stops = 0;
  for (const RepairLine& line : lines) {
    double priced_m = 0;
    for (const Polygon& swath : line.swaths) {
      swaths.push_back(bounds(swath));
      priced_m += std::max(area(swath) / kWidth_m, kWidth_m);
    }
    worked_m2 += kWidth_m * std::max(priced_m, 2 * kWidth_m);
    stops += line.line.stops;
  }
  const double left_m2 = left_of(gaps, swaths);
  const auto turns = static_cast<double>(lines.size());
  return prices.uncovered * left_m2 + prices.overlap * (worked_m2 - (gaps_m2 - left_m2)) +
         prices.turn * turns + prices.stop * stops;
}

std::vector<RepairLine> all_lines(const RepairGround& ground) {
  std::vector<RepairLine> out;
  for (const LinePosition& position : line_positions(ground))
    for (RepairLine& line : ground.lines_at(position)) out.push_back(std::move(line));
  return out;
}

/// The least cost of any three lines or fewer of those there are on the ground as it is.
double least_cost(const Scene& scene, const std::vector<RepairLine>& lines) {
  double least = cost_of(scene, {});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    least = std::min(least, cost_of(scene, {lines[i]}));
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, cost_of(scene, {lines[i], lines[j]}));
      for (std::size_t k = 0; k < j; ++k)
        least = std::min(least, cost_of(scene, {lines[i], lines[j], lines[k]}));
    }
  }
  return least;
}

/// No line may be left out, and none added, so that it costs less.
void expect_no_better_neighbour(const Scene& scene, const RepairGround& ground,
                                const std::vector<RepairLine>& lines) {
  const double cost = cost_of(scene, lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<RepairLine> fewer = lines;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_GE(cost_of(scene, fewer), cost - 1e-6) << "without line " << i;
  }
  for (const RepairLine& other : all_lines(ground)) {
    std::vector<RepairLine> more = lines;
    more.push_back(other);
    EXPECT_GE(cost_of(scene, more), cost - 1e-6) << "with a line at " << other.position.left_m;
  }
}

TEST(RepairChoice, IsAsGoodAsAnyOfThreeLines) {
  int repaired = 0, best = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene small = scene(random);
    RepairGround ground = small.ground();
    const double least = least_cost(small, all_lines(ground));
    const std::vector<RepairLine> chosen = chosen_lines(ground, SearchContext(1));
    EXPECT_NEAR(cost_with(chosen, ground), cost_of(small, chosen), 1e-4);
    EXPECT_LE(cost_of(small, chosen), 1.01 * least) << "no further than a per cent from the best";
    best += cost_of(small, chosen) <= least + 1e-4 ? 1 : 0;
    expect_no_better_neighbour(small, ground, chosen);
    repaired += chosen.empty() ? 0 : 1;
  }
  EXPECT_GE(best, 6);
  EXPECT_GT(repaired, 4) << "scenes have to be worth a repair";
}

TEST(RepairChoice, TheNumberOfThreadsChangesNothing) {
  std::mt19937_64 random(7);
  const Scene small = scene(random);
  RepairGround one = small.ground(), four = small.ground();
  const std::vector<RepairLine> a = chosen_lines(one, SearchContext(1)),
                                b = chosen_lines(four, SearchContext(4));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].swaths, b[i].swaths);
}

}  // namespace tramline::repair_choice_test
