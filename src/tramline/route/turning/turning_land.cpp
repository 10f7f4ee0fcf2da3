#include "tramline/route/turning/turning_land.h"

#include <cmath>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// No manoeuvre leads farther from the ends of its tracks.
double farthest_turn_m(const Machine& machine) {
  const Turning& turning = machine.turning;
  return 100 + 20 * (machine.radius_m + machine.width_m + std::abs(turning.implement_offset_m) +
                     turning.drawbar_m + turning.front_overhang_m + turning.rear_overhang_m + turning.lift_m +
                     turning.lower_m + turning.turning_speed_mps * turning.steering_time_s);
}

Region all_round(const Ring& outer, double margin_m) {
  const Box box = bounds(outer).grown(margin_m);
  return {
      {{{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}}, {}}};
}

Region land_with_obstacles(const Ring& outer, const Machine& machine, const PlanSettings& settings) {
  if (settings.boundary == EdgeKind::kHard || settings.headlands > 0) return {{outer, {}}};
  if (settings.turn_room_m >= 0) return buffered({{outer, {}}}, settings.turn_room_m);
  if (settings.headland_rule == HeadlandRule::kTurns) return {{outer, {}}};
  return all_round(outer, farthest_turn_m(machine));
}

}  // namespace

Region turning_land(const Field& field, const Machine& machine, const PlanSettings& settings) {
  Region obstacles;
  for (const Obstacle& obstacle : field.obstacles) obstacles.push_back(obstacle.shape);
  const Region land = land_with_obstacles(field.outer, machine, settings);
  return obstacles.empty() ? land : difference(land, unite(obstacles));
}

}  // namespace tramline
