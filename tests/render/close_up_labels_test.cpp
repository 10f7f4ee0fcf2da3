#include "tramline/render/close_up/close_up_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "detour_plan.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/render/page/labels.h"

namespace tramline::render {
namespace {

const Box kMap{0, 0, 1000, 800};

/// A page that shows 100 m × 80 m round (60, 30).
Canvas page() { return {PictureFormat::kPng, 1000, 800}; }
const MapView kView{{60, 30}, {500, 400}, 10};

/// A box of the page in the field, m.
Region in_field(const Box& px) {
  const auto x = [](double page_x) {
    return kView.centre_m.x + (page_x - kView.centre_px.x) / kView.px_per_m;
  };
  const auto y = [](double page_y) {
    return kView.centre_m.y - (page_y - kView.centre_px.y) / kView.px_per_m;
  };
  return {{box(x(px.min_x), y(px.max_y), x(px.max_x), y(px.min_y)), {}}};
}

double hidden_m2(const Plan& plan, const Box& label) {
  double out = 0;
  for (const Obstacle& obstacle : plan.field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle)
      out += area(intersection(in_field(label), {obstacle.shape}));
  return out;
}

/// Nearest distance of a label's box to a polygon, px.
double gap_px(const Box& label, const Polygon& shape) {
  for (double gap = 0; gap < 1000; gap += 1)
    if (area(intersection(in_field(label.grown(gap)), {shape})) > 0) return gap;
  return std::numeric_limits<double>::infinity();
}

Plan with_obstacles(const Region& shapes) {
  Plan plan = detour_plan();
  plan.field.obstacles.clear();
  for (const Polygon& shape : shapes) plan.field.obstacles.push_back({shape, ObstacleKind::kObstacle, ""});
  return plan;
}

std::vector<Box> obstacle_numbers(const Plan& plan) {
  Canvas canvas = page();
  canvas.use(kView, 1);
  std::vector<Box> occupied;
  draw_obstacle_numbers(canvas, plan, kMap, occupied);
  return occupied;
}

/// Two walls half a metre thick round an empty corner; thinner than a number is high.
const Polygon kCorner{{{40, 20}, {80, 20}, {80, 20.5}, {40.5, 20.5}, {40.5, 50}, {40, 50}}, {}};
const Polygon kHorseshoe{
    {{40, 20}, {80, 20}, {80, 50}, {79.5, 50}, {79.5, 20.5}, {40.5, 20.5}, {40.5, 50}, {40, 50}}, {}};
const Polygon kSlantingHedge{{{40, 10}, {80, 50}, {80, 50.2}, {40, 10.2}}, {}};

TEST(ObstacleNumbers, StandAtConcaveObstaclesAndNotInTheirGap) {
  for (const Polygon& shape : {kCorner, kHorseshoe, kSlantingHedge}) {
    const Plan plan = with_obstacles({shape});
    const std::vector<Box> numbers = obstacle_numbers(plan);
    ASSERT_EQ(numbers.size(), 1u);
    EXPECT_EQ(hidden_m2(plan, numbers[0]), 0);
    EXPECT_LT(gap_px(numbers[0], shape), 10);
  }
}

TEST(ObstacleNumbers, StandInConcaveObstaclesWithRoom) {
  const Polygon shape{{{40, 10}, {80, 10}, {80, 15}, {45, 15}, {45, 50}, {40, 50}}, {}};
  const std::vector<Box> numbers = obstacle_numbers(with_obstacles({shape}));
  ASSERT_EQ(numbers.size(), 1u);
  // Booleans move edges onto the precision grid.
  const double tolerance_m2 = kGridSize * perimeter(in_field(numbers[0]).front().outer);
  EXPECT_NEAR(area(intersection(in_field(numbers[0]), {shape})), area(in_field(numbers[0])), tolerance_m2);
}

TEST(ObstacleNumbers, HideNoPole) {
  Region poles;
  for (int i = 0; i < 40; ++i) {
    const double x = 30 + 7 * (i % 8), y = 10 + 8 * (i / 8);
    poles.push_back({box(x, y, x + 0.3, y + 0.3), {}});
    poles.push_back({box(x + 0.9, y + 0.9, x + 1.2, y + 1.2), {}});
  }
  const Plan plan = with_obstacles(poles);
  const std::vector<Box> numbers = obstacle_numbers(plan);
  EXPECT_EQ(numbers.size(), poles.size());
  for (const Box& number : numbers) EXPECT_EQ(hidden_m2(plan, number), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(intersects(numbers[i], numbers[j]));
}

using DrawLabels = void (*)(Canvas&, const Plan&, std::vector<Box>&);

std::vector<Box> labels(const Plan& plan, DrawLabels draw) {
  Canvas canvas = page();
  canvas.use(kView, 1);
  std::vector<Box> occupied;
  draw(canvas, plan, occupied);
  return occupied;
}

/// The plan with poles wherever a label stands without them.
Plan poles_under(Plan plan, const std::vector<Box>& labels) {
  for (const Box& label : labels) {
    const Point p = in_field(label).front().outer.front() + Point{0.5, 0.5};
    plan.field.obstacles.push_back(
        {{box(p.x, p.y, p.x + 0.3, p.y + 0.3), {}}, ObstacleKind::kObstacle, "pole"});
  }
  return plan;
}

TEST(CloseUpLabels, MakeWayForPoles) {
  for (const DrawLabels draw : {DrawLabels([](Canvas&canvas, const Plan&plan, std::vector<Box>&occupied) {
                                  draw_radii(canvas, plan, 0, kMap, occupied);
                                }),
                                DrawLabels([](Canvas&canvas, const Plan&plan, std::vector<Box>&occupied) {
                                  draw_strip_numbers(canvas, plan, kMap, occupied);
                                })}) {
    const Plan plan = detour_plan();
    const std::vector<Box> before = labels(plan, draw);
    ASSERT_GE(before.size(), 2u);
    const Plan crowded = poles_under(plan, before);
    EXPECT_GT(hidden_m2(crowded, before[0]), 0) << "the poles do not stand where the labels were";
    const std::vector<Box> after = labels(crowded, draw);
    EXPECT_EQ(after.size(), before.size());
    for (const Box& label : after) EXPECT_EQ(hidden_m2(crowded, label), 0);
  }
}

TEST(RoomiestPlace, IsInsideHoweverThinThePolygon) {
  for (const Polygon& shape : {kCorner, kHorseshoe, kSlantingHedge}) {
    const Point px = roomiest_point(shape, kView).centre;
    EXPECT_TRUE(contains(shape, in_field({px.x, px.y, px.x, px.y}).front().outer.front()));
  }
}

}  // namespace
}  // namespace tramline::render
