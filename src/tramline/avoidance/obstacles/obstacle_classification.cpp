#include "tramline/avoidance/obstacles/obstacle_classification.h"

#include <cmath>
#include <numbers>

#include "tramline/avoidance/obstacles/bridge.h"
#include "tramline/avoidance/obstacles/clusters.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"

namespace tramline {
namespace {

/// Land enclosed by hard land, which no machine can reach.
Region enclosed_by(const Region& hard) {
  Region out;
  for (const Polygon& polygon : hard)
    for (const Ring& hole : polygon.holes) out.push_back({reversed(hole), {}});
  return out;
}

/// Obstacles with all land nearer than the clearance. The chords of the round corners lie outside the circle,
/// not inside: GEOS gives a corner the nearest whole number of chords, which then turn by up to one and a
/// half times the quadrant's share.
Region with_clearance(const Region& obstacles, double clearance_m) {
  constexpr int kChordsPerQuadrant = 16;
  if (clearance_m == 0) return obstacles;
  const double apothem = std::cos(1.5 * std::numbers::pi / (4 * kChordsPerQuadrant));
  return buffered(obstacles, clearance_m / apothem, JoinStyle::kRound, kChordsPerQuadrant);
}

/// Versleijen's obstacle category c: an obstacle nearer to the field's edge than the working width is joined
/// to the edge (table 3). Gives up the land between the edge and every cluster nearer to it than `width_m`.
/// The rim of a clipped obstacle stays hard.
void clip_to_edge(std::vector<Cluster>& clusters, const Ring& outer, double width_m) {
  for (Cluster& cluster : clusters) {
    if (distance_to_ring(cluster.obstacles, outer) >= width_m) continue;
    const Region between = bridge(outer, cluster.obstacles, width_m);
    cluster.given_up.insert(cluster.given_up.end(), between.begin(), between.end());
  }
}

}  // namespace

ClassifiedGround classify_obstacles(const Field& field, double width_m, double clearance_m) {
  const Region obstacles = obstacle_shapes(field, ObstacleKind::kObstacle);
  const Region whole{{field.outer, {}}};
  ClassifiedGround ground;
  ground.passable = obstacle_shapes(field, ObstacleKind::kPassable);
  ground.body = body_of(field);

  std::vector<Cluster> groups = clusters(obstacles, width_m + 2 * clearance_m);
  clip_to_edge(groups, field.outer, width_m + clearance_m);
  Region between;
  for (const Cluster& group : groups)
    between.insert(between.end(), group.given_up.begin(), group.given_up.end());

  const Region solid = unite(obstacles);
  if (clearance_m > 0) {
    const Region kept_clear = with_clearance(solid, clearance_m);
    between.insert(between.end(), kept_clear.begin(), kept_clear.end());
    ground.beyond = difference(kept_clear, whole);
  }
  ground.given_up = intersection(unite(between), ground.body);
  const Region enclosed = intersection(enclosed_by(unite(solid, ground.given_up)), ground.body);
  if (!enclosed.empty()) ground.given_up = unite(ground.given_up, enclosed);
  ground.hard = unite(solid, ground.given_up);
  ground.plannable = difference(whole, ground.hard);
  const Region kept_off = ground.beyond.empty() ? ground.hard : unite(ground.hard, ground.beyond);
  ground.hazards = hazards_of(kept_off, field, clearance_m);
  return ground;
}

}  // namespace tramline
