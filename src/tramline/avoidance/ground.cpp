#include "tramline/avoidance/ground.h"

#include "tramline/avoidance/clusters.h"
#include "tramline/avoidance/edge_clips.h"
#include "tramline/geometry/boolean.h"
#include "tramline/headland/body.h"

namespace tramline {

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
  if (!between.empty()) ground.given_up = intersection(unite(between), ground.body);
  ground.hard = unite(solid, ground.given_up);
  ground.plannable = difference(whole, ground.hard);
  return ground;
}

}  // namespace tramline
