#include "properties/random_drive.h"

#include <utility>

#include "properties/draws.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline::testing {
namespace {

Ring random_convex_land(std::mt19937_64& random) {
  const double wide_m = uniform(random, 15, 70), long_m = uniform(random, 25, 90);
  std::vector<Point> corners;
  for (int i = 0; i < 9; ++i) corners.push_back({uniform(random, 0, wide_m), uniform(random, 0, long_m)});
  return hull_of(std::move(corners));
}

}  // namespace

std::vector<Point> DriveScene::corners() const {
  std::vector<Point> out;
  for (const Box& box : outline_of(machine).on_machine)
    for (const Point corner : corners_of(box)) out.push_back(corner);
  return out;
}

std::optional<DriveScene> random_drive_scene(std::mt19937_64& random) {
  DriveScene out;
  out.machine.width_m = uniform(random, 3, 24);
  out.machine.radius_m = uniform(random, 3, 9);
  if (any_of(random, 0, 1) == 1) {
    out.machine.turning.front_overhang_m = uniform(random, 0, 4);
    out.machine.turning.vehicle_width_m = 2;
    out.machine.turning.implement_offset_m = uniform(random, -2, 3);
  }
  out.land = random_convex_land(random);
  const Box box = bounds(out.land);
  out.from = {{uniform(random, box.min_x, box.max_x), uniform(random, box.min_y, box.max_y)},
              Heading::clockwise_from_north(Angle::degrees(uniform(random, 0, 360)))};
  out.gear = any_of(random, 0, 1) == 0 ? Gear::kForward : Gear::kReverse;
  if (!AllowedLand({{out.land, {}}}).holds(out.from, outline_of(out.machine))) return std::nullopt;
  return out;
}

SteeredPath driven_at_random(const DriveScene& scene, std::mt19937_64& random) {
  const AllowedLand land({{scene.land, {}}});
  SteeredPath out;
  Pose at = scene.from;
  for (int i = 0; i < 40; ++i) {
    const double sharp = any_of(random, 0, 2) == 0 ? uniform(random, -1, 1) : any_of(random, -1, 1);
    const SteeredPath next{
        arc_from(at, uniform(random, 0.5, 12), sharp / scene.machine.radius_m, scene.gear)};
    if (!land.fits(next, outline_of(scene.machine))) continue;
    out.push_back(next.front());
    at = end_of(out.back());
  }
  return out;
}

}  // namespace tramline::testing
