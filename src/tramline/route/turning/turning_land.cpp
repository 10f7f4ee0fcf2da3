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
  const std::optional<double> beyond_m = land_beyond_m(settings);
  if (!beyond_m) return all_round(outer, farthest_turn_m(machine));
  return *beyond_m > 0 ? buffered({{outer, {}}}, *beyond_m) : Region{{outer, {}}};
}

}  // namespace

std::optional<double> land_beyond_m(const PlanSettings& settings) {
  if (settings.boundary == EdgeKind::kHard || settings.headlands > 0) return 0;
  if (settings.turn_room_m >= 0) return settings.turn_room_m;
  if (settings.headland_rule == HeadlandRule::kTurns) return 0;
  return std::nullopt;
}

Region turning_land(const Field& field, const Machine& machine, const PlanSettings& settings) {
  Region obstacles;
  for (const Obstacle& obstacle : field.obstacles) obstacles.push_back(obstacle.shape);
  const Region land = land_with_obstacles(field.outer, machine, settings);
  return obstacles.empty() ? land : difference(land, unite(obstacles));
}

}  // namespace tramline
