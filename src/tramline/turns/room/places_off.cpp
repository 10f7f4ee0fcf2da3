#include "tramline/turns/room/places_off.h"

#include <cassert>
#include <cmath>
#include <optional>

#include "tramline/turns/outline/towed_motion.h"

namespace tramline {
namespace {

void append_places_off(const LandEdges& land, const Box& part, const Placement& frame, double step_m,
                       std::vector<Point>& out) {
  const auto corners = corners_of(part);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point side = corners[(i + 1) % corners.size()] - corners[i];
    const double steps = std::ceil(length(side) / step_m);
    for (double k = 0; k < std::max(1.0, steps); ++k) {
      const Point at = to_ground(frame, corners[i] + (steps > 0 ? k / steps : 0) * side);
      if (!land.contains(at)) out.push_back(at);
    }
  }
}

}  // namespace

std::vector<Point> places_off(const LandEdges& land, const SteeredPath& path, const Outline& outline,
                              double step_m) {
  assert(step_m > 0);
  std::optional<TowedMotion> towed;
  if (outline.tows() && !path.empty()) towed.emplace(path, outline);
  std::vector<Point> out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double steps = std::ceil(path[i].length_m / step_m);
    for (double k = 0; k <= steps; ++k) {
      const double after_m = steps > 0 ? k / steps * path[i].length_m : 0;
      for (const Box& part : outline.on_machine)
        append_places_off(land, part, placed(pose_after(path[i], after_m)), step_m, out);
      for (const Box& part : outline.on_implement)
        append_places_off(land, part, towed->implement(i, after_m), step_m, out);
    }
  }
  return out;
}

}  // namespace tramline
