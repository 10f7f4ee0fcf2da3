#include "tramline/headland/pass_boundaries.h"

#include <algorithm>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/significant_vertices.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

Ring without_idle_vertices(const Ring& ring) {
  Ring out;
  for (const std::size_t i : significant_vertices(ring, kIdleVertex_m)) out.push_back(ring[i]);
  return out;
}

}  // namespace

std::vector<Boundary> boundaries_of(const Field& field, const HeadlandTerms& terms) {
  std::vector<Boundary> out{{without_idle_vertices(field.outer), terms.field_passes, std::nullopt}};
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    const Obstacle& obstacle = field.obstacles[i];
    if (obstacle.kind != ObstacleKind::kObstacle) continue;
    const int passes = i < terms.obstacle_passes.size() ? terms.obstacle_passes[i] : 0;
    out.push_back({without_idle_vertices(reversed(obstacle.shape.outer)), passes, i, terms.clearance_m});
  }
  std::erase_if(out, [](const Boundary& boundary) { return boundary.ring.size() < 3; });
  return out;
}

double pass_distance_m(const Boundary& boundary, int pass, double width_m) {
  return boundary.clearance_m + (std::min(pass, boundary.passes + 1) - 0.5) * width_m;
}

double headland_depth_m(const Boundary& boundary, int passes, double width_m) {
  return boundary.clearance_m + passes * width_m;
}

Region land_inside_obstacles(const Field& field, const std::vector<Boundary>& boundaries) {
  Region out;
  for (const Boundary& boundary : boundaries)
    if (boundary.obstacle && boundary.passes > 0)
      for (const Ring& hole : field.obstacles[*boundary.obstacle].shape.holes) {
        const Region inside{{reversed(hole), {}}};
        const Region kept = boundary.clearance_m > 0 ? buffered(inside, -boundary.clearance_m) : inside;
        out.insert(out.end(), kept.begin(), kept.end());
      }
  return out;
}

Region land_behind_headlands(const std::vector<Boundary>& boundaries, double width_m) {
  std::vector<OffsetBoundary> offset_boundaries;
  double deepest = width_m;
  for (const Boundary& boundary : boundaries) {
    const double depth = headland_depth_m(boundary, boundary.passes, width_m);
    deepest = std::max(deepest, depth);
    if (boundary.passes > 0) offset_boundaries.push_back({boundary.ring, depth});
  }
  if (boundaries.front().passes == 0) {  // an offset boundary beyond the field instead
    const Box b = bounds(boundaries.front().ring).grown(3 * deepest);
    offset_boundaries.push_back(
        {{{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}}, width_m});
  }
  return offset_region(offset_rings(offset_boundaries), kBodySagitta);
}

}  // namespace tramline
