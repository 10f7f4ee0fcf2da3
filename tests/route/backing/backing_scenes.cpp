#include "route/backing/backing_scenes.h"

#include "properties/draws.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/outline/outline.h"

namespace tramline::testing {

Heading towards_deg(double clockwise_from_north) {
  return Heading::clockwise_from_north(Angle::degrees(clockwise_from_north));
}

Machine six_metres() {
  Machine out;
  out.width_m = out.radius_m = 6;
  out.turning.turning_speed_mps = 1.5;
  out.turning.reverse_speed_mps = 1;
  out.turning.gear_change_s = 2;
  return out;
}

Ring rectangle_of(double wide_m, double long_m) {
  return {{0, 0}, {wide_m, 0}, {wide_m, long_m}, {0, long_m}};
}

SteeredPath north_to(Point at, double length_m) {
  return {arc_from({at - Point{0, length_m}, towards_deg(0)}, length_m, 0, Gear::kForward)};
}
SteeredPath south_from(Point at, double length_m) {
  return {arc_from({at, towards_deg(180)}, length_m, 0, Gear::kForward)};
}

Ring random_field_of_sides(std::mt19937_64& random) {
  const double wide_m = uniform(random, 9, 60), long_m = uniform(random, 40, 120);
  Ring out = rectangle_of(wide_m, long_m);
  const double skew = any_of(random, 0, 2) > 0 ? 1 : 0;
  for (Point& corner : out) corner = corner + skew * Point{uniform(random, -2, 2), uniform(random, -15, 15)};
  if (any_of(random, 0, 1) == 1)
    out.insert(out.begin() + 3, 0.5 * (out[2] + out[3]) + Point{0, uniform(random, 1, 10)});
  return out;
}

std::optional<Line> random_line(const Ring& field, const AllowedLand& land, const Machine& machine,
                                std::mt19937_64& random) {
  const Box box = bounds(field);
  const Outline outline = outline_of(machine);
  Pose pose{{uniform(random, box.min_x, box.max_x), uniform(random, box.min_y, box.max_y)},
            towards_deg(any_of(random, 0, 3) * 90 + uniform(random, -30, 30) * any_of(random, 0, 1))};
  if (!land.holds(pose, outline)) return std::nullopt;
  const double short_m = any_of(random, 0, 2) * uniform(random, 0, 6);
  const bool to_edge = any_of(random, 0, 3) > 0;
  while (to_edge && land.holds(moved_on(pose, 0.2 + short_m), outline)) pose = moved_on(pose, 0.2);
  Line out;
  out.bent = any_of(random, 0, 2) == 0;
  SteeredPath back;
  const double straight_m = uniform(random, 1, 60);
  if (out.bent) {
    back.push_back(arc_from(pose, uniform(random, 0, 8), 0, Gear::kReverse));
    const double radius_m = machine.radius_m * uniform(random, 1, 4);
    const double turned = any_of(random, 0, 2) > 0 ? uniform(random, 0, 0.7) : uniform(random, 0.5, 1.7);
    back.push_back(arc_from(end_of(back), turned * radius_m, (any_of(random, 0, 1) == 0 ? 1 : -1) / radius_m,
                            Gear::kReverse));
    out.turns_far = turned > 0.5;
  }
  back.push_back(arc_from(back.empty() ? pose : end_of(back), straight_m, 0, Gear::kReverse));
  out.driven = retraced(back);
  // From behind a bend the machine has come along the line.
  if (out.turns_far && !land.fits(out.driven, outline)) return std::nullopt;
  return out;
}

Machine random_machine_that_backs(std::mt19937_64& random) {
  Machine out;
  out.width_m = uniform(random, 2, 10);
  out.radius_m = uniform(random, 3, 9);
  out.turning.lift_m = any_of(random, 0, 1) * uniform(random, 0, 3);
  out.turning.lower_m = any_of(random, 0, 1) * uniform(random, 0, 3);
  out.turning.reverse_speed_mps = uniform(random, 0.5, 2);
  out.turning.gear_change_s = uniform(random, 0, 3);
  if (any_of(random, 0, 2) > 0) return out;
  out.turning.front_overhang_m = uniform(random, 0, 3);
  out.turning.vehicle_width_m = 2;
  out.turning.implement_offset_m = uniform(random, -2, 2);
  return out;
}

}  // namespace tramline::testing
