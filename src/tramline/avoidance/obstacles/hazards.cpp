#include "tramline/avoidance/obstacles/hazards.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// The centre of gravity of a ring's area.
Point centroid(const Ring& ring) {
  const Point base = ring.front();
  Point sum;
  double twice_area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - base, b = ring[i + 1 == ring.size() ? 0 : i + 1] - base;
    const double part = cross(a, b);
    sum = sum + part * (a + b);
    twice_area += part;
  }
  return base + (1 / (3 * twice_area)) * sum;
}

/// Whether most of it lies in the polygon, or the polygon is nearer to it than the clearance.
bool belongs(const Polygon& obstacle, const Polygon& polygon, double clearance_m) {
  if (area(intersection({obstacle}, {polygon})) > 0.5 * area(obstacle)) return true;
  return clearance_m > 0 && distance_between({obstacle}, {polygon}) < clearance_m;
}

}  // namespace

std::optional<Circle> circle_of(const Ring& ring) {
  constexpr std::size_t kFewest = 8;
  constexpr double kOff_share = 0.01;
  if (ring.size() < kFewest || signed_area(ring) == 0) return std::nullopt;
  Circle circle{centroid(ring), 0};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point p : ring) {
    circle.radius = std::max(circle.radius, distance(p, circle.centre));
    nearest = std::min(nearest, distance(p, circle.centre));
  }
  if (nearest < (1 - kOff_share) * circle.radius) return std::nullopt;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]) > circle.radius) return std::nullopt;
  return circle;
}

std::vector<Hazard> hazards_of(const Region& hard, const Field& field, double clearance_m) {
  std::vector<Hazard> out;
  for (const Polygon& polygon : hard) {
    Hazard hazard{polygon, {}, {}};
    const Box reach = bounds(polygon).grown(clearance_m);
    for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
      const Obstacle& obstacle = field.obstacles[i];
      if (obstacle.kind != ObstacleKind::kObstacle || !intersects(bounds(obstacle.shape), reach)) continue;
      if (belongs(obstacle.shape, polygon, clearance_m)) hazard.obstacles.push_back(i);
    }
    if (hazard.obstacles.size() == 1) hazard.round = circle_of(polygon.outer);
    out.push_back(std::move(hazard));
  }
  return out;
}

}  // namespace tramline
