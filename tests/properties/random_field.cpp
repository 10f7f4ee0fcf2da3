#include "properties/random_field.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::testing {
namespace {

double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Field transformed(Field field, const std::function<Point(Point)>& move) {
  const auto apply = [&move](Ring& ring) {
    for (Point& p : ring) p = move(p);
  };
  apply(field.outer);
  for (Obstacle& obstacle : field.obstacles) {
    apply(obstacle.shape.outer);
    for (Ring& hole : obstacle.shape.holes) apply(hole);
  }
  return field;
}

}  // namespace

double on_grid(double value) { return std::round(value / kGridSize) * kGridSize; }

Ring random_star(std::mt19937_64& random, Point centre, double least_radius, double most_radius,
                 int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + uniform(random, -0.35, 0.35)) / corners;
    const double radius = uniform(random, least_radius, most_radius);
    ring.push_back(
        {on_grid(centre.x + radius * std::cos(angle)), on_grid(centre.y + radius * std::sin(angle))});
  }
  return ring;
}

Field random_field(std::mt19937_64& random, int most_obstacles) {
  Field field;
  field.id = "random";
  const double size = uniform(random, 40, 200);
  const int corners = std::uniform_int_distribution<int>(4, 25)(random);
  field.outer = random_star(random, {0, 0}, 0.45 * size, size, corners);
  const int wanted = std::uniform_int_distribution<int>(0, most_obstacles)(random);
  for (int tries = 0; tries < 4 * wanted && static_cast<int>(field.obstacles.size()) < wanted; ++tries) {
    const double radius = std::exp(uniform(random, 0.0, 3.2));
    const Point centre{uniform(random, -size, size), uniform(random, -size, size)};
    const Polygon shape{
        random_star(random, centre, 0.5 * radius, radius, std::uniform_int_distribution<int>(3, 9)(random)),
        {}};
    if (area(difference({shape}, {{field.outer, {}}})) > 0) continue;
    bool free = true;
    for (const Obstacle& other : field.obstacles)
      free = free && area(intersection({shape}, {other.shape})) == 0;
    if (free) field.obstacles.push_back({shape, ObstacleKind::kObstacle, "obstacle"});
  }
  return field;
}

Field shifted(const Field& field, Point by) {
  return transformed(field, [by](Point p) { return p + by; });
}

Field quarter_turned(const Field& field) {
  return transformed(field, [](Point p) { return Point{-p.y, p.x}; });
}

int case_count(int standard) {
  const char* wanted = std::getenv("TRAMLINE_CASES");
  return wanted != nullptr ? std::atoi(wanted) : standard;
}

unsigned long long base_seed() {
  const char* wanted = std::getenv("TRAMLINE_SEED");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 20260101ULL;
}

}  // namespace tramline::testing
