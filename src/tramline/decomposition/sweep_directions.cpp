#include "tramline/decomposition/sweep_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/decomposition/tolerances.h"

namespace tramline {
namespace {

struct Kept {
  Direction direction;
  double length_m = 0;  ///< of all edges along it
};

void add_lengths(const Ring& ring, std::vector<Kept>& all) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a == b) continue;
    const Direction along = Direction::along(a, b);
    // The last direction not beyond the edge's by more than rounding.
    auto at = std::upper_bound(all.begin(), all.end(), along, [](Direction one, const Kept& other) {
      return one.angle().radians() + kSameDirectionRadians < other.direction.angle().radians();
    });
    if (at == all.begin()) at = all.end();
    (at - 1)->length_m += distance(a, b);
  }
}

}  // namespace

std::vector<Direction> sweep_directions(const Field& field) {
  std::vector<Direction> directions = candidate_directions(field);
  if (directions.size() <= kMostSweepDirections) return directions;
  std::vector<Kept> all;
  for (const Direction direction : directions) all.push_back({direction, 0});
  add_lengths(field.outer, all);
  for (const Obstacle& obstacle : field.obstacles) {
    if (obstacle.kind == ObstacleKind::kPassable) continue;
    add_lengths(obstacle.shape.outer, all);
    for (const Ring& hole : obstacle.shape.holes) add_lengths(hole, all);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Kept& a, const Kept& b) { return a.length_m > b.length_m; });
  const Angle apart = Angle::radians(std::numbers::pi / static_cast<double>(kThinnedDirections));
  directions.clear();
  for (const Kept& next : all)
    if (std::none_of(directions.begin(), directions.end(), [&](Direction kept) {
          return angle_between(kept, next.direction).radians() < apart.radians();
        }))
      directions.push_back(next.direction);
  std::sort(directions.begin(), directions.end());
  return directions;
}

}  // namespace tramline
