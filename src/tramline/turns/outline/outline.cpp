#include "tramline/turns/outline/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline {

Outline outline_of(const Machine& machine) {
  const Turning& turning = machine.turning;
  assert(machine.width_m > 0);
  assert(turning.front_overhang_m >= 0 && turning.rear_overhang_m >= 0);
  Outline out;
  if (turning.front_overhang_m > 0 || turning.vehicle_width_m > 0)
    out.on_machine.push_back(
        {0, -0.5 * turning.vehicle_width_m, turning.front_overhang_m, 0.5 * turning.vehicle_width_m});
  const auto bar_at = [&](double x) {
    return Box{x - turning.rear_overhang_m, -0.5 * machine.width_m, x, 0.5 * machine.width_m};
  };
  if (turning.implement == Coupling::kTowed && turning.drawbar_m > 0) {
    out.hitch_m = turning.implement_offset_m;
    out.drawbar_m = turning.drawbar_m;
    out.on_implement = {bar_at(0), {0, 0, turning.drawbar_m, 0}};
  } else {
    out.on_machine.push_back(bar_at(-turning.implement_offset_m));
  }
  return out;
}

std::array<Point, 4> corners_of(const Box& part) {
  return {Point{part.min_x, part.min_y}, Point{part.max_x, part.min_y}, Point{part.max_x, part.max_y},
          Point{part.min_x, part.max_y}};
}

double farthest_corner_m(const Box& part) {
  return std::hypot(std::max(-part.min_x, part.max_x), std::max(-part.min_y, part.max_y));
}

double half_breadth_m(const Outline& outline) {
  double out_m = 0;
  for (const std::vector<Box>* boxes : {&outline.on_machine, &outline.on_implement})
    for (const Box& box : *boxes) out_m = std::max({out_m, box.max_y, -box.min_y});
  return out_m;
}

}  // namespace tramline
