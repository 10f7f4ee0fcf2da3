#pragma once
// Land on which a machine follows the lines beside its boundary.

#include <utility>

#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/route/connection/connector.h"

namespace tramline::testing {

struct DrivenLand {
  DrivenLand(Polygon shape, Machine drives)
      : region{std::move(shape)},
        machine(std::move(drives)),
        land(region),
        ground(land, field, machine, region),
        roadmap([this] { return Roadmap(lines_beside_boundaries({}, field, ground), 3); }, ground),
        connector(ground, roadmap, {}) {
    field.outer = region.front().outer;
  }
  DrivenLand(const DrivenLand&) = delete;
  DrivenLand& operator=(const DrivenLand&) = delete;

  Region region;
  Field field{};
  Machine machine;
  AllowedLand land;
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;
};

/// A work, from a place to the north or to the south.
inline SteeredPath northwards(Point from, double length_m) {
  return {arc_from({from, Heading::from_to({0, 0}, {0, 1})}, length_m, 0, Gear::kForward)};
}
inline SteeredPath southwards(Point from, double length_m) {
  return {arc_from({from, Heading::from_to({0, 1}, {0, 0})}, length_m, 0, Gear::kForward)};
}

inline Machine six_metres_wide(double radius_m) {
  Machine out;
  out.width_m = 6;
  out.radius_m = radius_m;
  return out;
}

/// A room of a hectare with an arm 13 m wide and 60 m long north of it, from x = 40 m on.
inline Polygon room_with_an_arm() {
  return {{{0, 0}, {100, 0}, {100, 100}, {53, 100}, {53, 160}, {40, 160}, {40, 100}, {0, 100}}, {}};
}

}  // namespace tramline::testing
