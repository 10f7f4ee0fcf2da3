#include "tramline/admission/repair_part.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/admission/clip_holes.h"
#include "tramline/admission/orient_rings.h"
#include "tramline/admission/project_rings.h"
#include "tramline/admission/remove_duplicate_points.h"
#include "tramline/admission/remove_spikes.h"
#include "tramline/admission/repair_crossings.h"
#include "tramline/admission/thin_rings.h"
#include "tramline/admission/tolerances.h"
#include "tramline/admission/unite_obstacles.h"

namespace tramline {
namespace {

std::vector<WorkRing> cleaned_rings(const RawPolygon& part, RepairLog& repair_log) {
  std::vector<WorkRing> rings;
  for (std::size_t r = 0; r < part.rings.size(); ++r)
    rings.push_back(project_ring(part.rings[r], ring_name(r), repair_log));
  thin_rings(rings, repair_log);
  for (WorkRing& ring : rings) {
    remove_duplicate_points(ring, repair_log);
    remove_spikes(ring, repair_log);
  }
  return rings;
}

/// The holes drawn, each as one obstacle per lobe; holes without area are dropped.
std::vector<Obstacle> drawn_holes(const std::vector<WorkRing>& rings, RepairLog& repair_log) {
  std::vector<Obstacle> holes;
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const Ring& points = rings[r].points;
    Region shapes = points.size() < 3 ? Region{} : repair_crossings(rings[r], RingRole::kHole, repair_log);
    if (area(shapes) <= kNoArea_m2) {
      if (!points.empty())
        repair_log.repair(fmt::format("{} has no area; it was dropped", rings[r].name), rings[r].name,
                          points.front(), shapes.empty() ? 0 : area(shapes));
      continue;
    }
    for (Polygon& shape : shapes) holes.push_back({std::move(shape), ObstacleKind::kObstacle, rings[r].name});
  }
  return holes;
}

/// Land that the outer ring goes round without containing it, numbered on after the holes drawn.
void append_enclosed_holes(const Region& lobes, std::size_t number,
                           std::vector<std::vector<Obstacle>>& obstacles) {
  for (std::size_t k = 0; k < lobes.size(); ++k)
    for (const Ring& ring : lobes[k].holes)
      obstacles[k].push_back({{reversed(ring), {}},
                              ObstacleKind::kObstacle,
                              fmt::format("hole {} (enclosed by the outer ring)", number++)});
}

}  // namespace

std::vector<Lobe> repair_part(const RawPolygon& part, RingWinding winding, RepairLog& repair_log,
                              std::string& why_empty) {
  std::vector<WorkRing> rings = cleaned_rings(part, repair_log);
  if (rings.empty() || rings[0].points.size() < 3) {
    why_empty = "its outer ring has fewer than three distinct points that enclose land";
    return {};
  }
  orient_rings(rings, winding, repair_log);
  const Region enclosed = repair_crossings(rings[0], RingRole::kOuter, repair_log);
  if (area(enclosed) <= kNoArea_m2) {
    why_empty = "its outer ring encloses no area";
    return {};
  }
  std::vector<Ring> outers;
  for (const Polygon& lobe : enclosed) outers.push_back(lobe.outer);
  std::vector<std::vector<Obstacle>> sorted = clip_holes(outers, drawn_holes(rings, repair_log), repair_log);
  append_enclosed_holes(enclosed, rings.size(), sorted);

  std::vector<Lobe> lobes;
  double left_m2 = 0;
  for (std::size_t k = 0; k < outers.size(); ++k) {
    lobes.push_back({outers[k], unite_obstacles(std::move(sorted[k]), &repair_log)});
    left_m2 += signed_area(outers[k]);
    for (const Obstacle& obstacle : lobes.back().obstacles) left_m2 -= area(obstacle.shape);
  }
  if (left_m2 > kNoArea_m2) return lobes;
  why_empty = "its holes cover it completely";
  return {};
}

}  // namespace tramline
