#pragma once
// The hard land that tracks have to keep away from, piece by piece with the obstacles in it.

#include <optional>
#include <vector>

#include "tramline/model/field.h"

namespace tramline {

struct Circle {
  Point centre;
  double radius = 0;
};

/// One connected piece of hard land: an obstacle, or several with the land given up between them.
struct Hazard {
  Polygon shape;
  std::vector<std::size_t> obstacles;  ///< indices into Field::obstacles
  std::optional<Circle> round;  ///< where it is one obstacle in the shape of a circle (Versleijen eq. 3)
};

/// The circle that a ring approximates, through its farthest vertex: at least 8 vertices lie on it to 1 % of
/// its radius, and none of the chords turns by more than 60 degrees.
std::optional<Circle> circle_of(const Ring& ring);

/// One hazard for each polygon of `hard`, in their order. Land kept clear that passable land separates from
/// its obstacle belongs to that obstacle's hazard too. O(n·m) boxes.
std::vector<Hazard> hazards_of(const Region& hard, const Field& field, double clearance_m = 0);

}  // namespace tramline
