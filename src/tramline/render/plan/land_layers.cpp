#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

Region shapes_of(const Field& field, ObstacleKind kind) {
  Region out;
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == kind) out.push_back(obstacle.shape);
  return out;
}

// The outline also keeps what is smaller than a pixel on the page in sight.
void draw_hatched(Canvas& canvas, const Region& region, Colour ground, const Hatch& style,
                  const Stroke& edge) {
  if (region.empty()) return;
  fill(canvas, region, ground);
  hatch(canvas, region, style);
  outline(canvas, region, {edge.colour, edge.width_px * canvas.scale()});
}

}  // namespace

void draw_ground(Canvas& canvas, const Plan& plan) {
  fill(canvas, {{plan.field.outer, {}}}, kFieldColour);
  if (!plan.worked.empty()) fill(canvas, plan.worked, kCoveredColour);
  draw_headland_ground(canvas, plan);
  for (std::size_t i = 0; i < plan.subfields.size(); ++i) fill(canvas, {plan.subfields[i].shape}, tint(i));
}

void draw_obstacles(Canvas& canvas, const Plan& plan) {
  draw_hatched(canvas, shapes_of(plan.field, ObstacleKind::kPassable), kPassableColour, passable_hatch(),
               {kPassableHatch, 1.4});
  draw_hatched(canvas, shapes_of(plan.field, ObstacleKind::kObstacle), kObstacleColour, obstacle_hatch(),
               {kObstacleColour, 1.8});
}

void draw_outlines(Canvas& canvas, const Plan& plan) {
  for (const Subfield& subfield : plan.subfields)
    outline(canvas, {subfield.shape}, {kSubfieldEdge, 1.4 * canvas.scale()});
  outline(canvas, {{plan.field.outer, {}}}, {kFieldEdge, kOutlineWidth * canvas.scale()});
}

}  // namespace tramline::render
