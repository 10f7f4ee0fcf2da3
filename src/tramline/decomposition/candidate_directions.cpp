#include "tramline/decomposition/candidate_directions.h"

#include <algorithm>

#include "tramline/decomposition/tolerances.h"

namespace tramline {
namespace {

void append_edge_directions(const Ring& ring, std::vector<Direction>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a != b) out.push_back(Direction::along(a, b));
  }
}

bool same(Direction a, Direction b) { return angle_between(a, b).radians() <= kSameDirectionRadians; }

}  // namespace

std::vector<Direction> candidate_directions(const Field& field) {
  std::vector<Direction> all;
  append_edge_directions(field.outer, all);
  for (const Obstacle& obstacle : field.obstacles) {
    if (obstacle.kind == ObstacleKind::kPassable) continue;
    append_edge_directions(obstacle.shape.outer, all);
    for (const Ring& hole : obstacle.shape.holes) append_edge_directions(hole, all);
  }
  std::sort(all.begin(), all.end());
  std::vector<Direction> distinct;
  for (const Direction direction : all)
    if (distinct.empty() || !same(distinct.back(), direction)) distinct.push_back(direction);
  // 179.9999999 and 0 degrees are neighbours as well.
  if (distinct.size() > 1 && same(distinct.front(), distinct.back())) distinct.pop_back();
  return distinct;
}

}  // namespace tramline
