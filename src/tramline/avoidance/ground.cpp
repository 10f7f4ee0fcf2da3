#include "tramline/avoidance/ground.h"

#include "tramline/avoidance/clusters.h"
#include "tramline/avoidance/edge_clips.h"
#include "tramline/geometry/boolean.h"
#include "tramline/headland/body.h"

namespace tramline {
namespace {

/// Land that hard land goes all round: no machine gets there.
Region enclosed_by(const Region& hard) {
  Region out;
  for (const Polygon& polygon : hard)
    for (const Ring& hole : polygon.holes) out.push_back({reversed(hole), {}});
  return out;
}

}  // namespace

Ground sort_obstacles(const Field& field, double width_m) {
  const Region obstacles = obstacle_shapes(field, ObstacleKind::kObstacle);
  const Region whole{{field.outer, {}}};
  Ground ground;
  ground.passable = obstacle_shapes(field, ObstacleKind::kPassable);
  ground.body = body_of(field);

  std::vector<Cluster> groups = clusters(obstacles, width_m);
  clip_to_edge(groups, field.outer, width_m);
  Region between;
  for (const Cluster& group : groups)
    between.insert(between.end(), group.given_up.begin(), group.given_up.end());

  const Region solid = unite(obstacles);
  ground.given_up = intersection(unite(between), ground.body);
  const Region enclosed = intersection(enclosed_by(unite(solid, ground.given_up)), ground.body);
  if (!enclosed.empty()) ground.given_up = unite(ground.given_up, enclosed);
  ground.hard = unite(solid, ground.given_up);
  ground.plannable = difference(whole, ground.hard);
  return ground;
}

}  // namespace tramline
