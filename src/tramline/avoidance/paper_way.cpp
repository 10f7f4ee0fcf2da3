#include "tramline/avoidance/paper_way.h"

#include <algorithm>

#include "tramline/avoidance/detour_frame.h"
#include "tramline/avoidance/detour_path.h"

namespace tramline {
namespace {

/// How far the hazard's own outline lies to the left of the track, at most.
double farthest_left(const TurnedHazard& hazard, double centre) {
  if (hazard.round) return centre - hazard.round->centre.x + hazard.round->radius;
  return centre - hazard.box.min_x;
}
double farthest_right(const TurnedHazard& hazard, double centre) {
  if (hazard.round) return hazard.round->centre.x - centre + hazard.round->radius;
  return hazard.box.max_x - centre;
}

bool convex(const Ring& ring) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (cross(b - a, c - b) < -kRounding) return false;
  }
  return true;
}

/// What the middle of the detour runs along.
std::vector<KeepOut> buffer_of(const TurnedHazard& hazard, const DetourFrame& frame, double half_width,
                               double radius) {
  if (hazard.round)
    return {{frame.to_detour(hazard.round->centre), std::max(hazard.round->radius + half_width, radius)}};
  std::vector<KeepOut> out;
  for (const Point corner : hazard.outline) out.push_back({frame.to_detour(corner), half_width});
  return out;
}

/// Why the path, fitted into the track, cannot be driven; empty where it can.
std::string fault_in_track(const Obstruction& o, const TrackDetour& detour, const Surroundings& around) {
  const Intervals& stretches = o.strip.stretches;
  if (stretch_at(stretches, detour.from) != o.gap - 1 || stretch_at(stretches, detour.to) != o.gap)
    return "the track ends before the detour could";
  const double least = std::max(o.radius_m, 0.5 * o.width_m);
  if (smallest_radius(detour.path) < least * (1 - 1e-9)) return "it is too tight in the middle";
  const SwathLine line(detour.path, o.width_m);
  for (const TurnedHazard& hazard : around.hazards)
    if (runs_into(line, hazard)) return "it would meet an obstacle";
  return fault_of(line, around);
}

}  // namespace

WayRound paper_way(const Obstruction& o, double threshold_m, const Surroundings& around) {
  WayRound out;
  out.first_gap = out.last_gap = o.gap;
  const Intervals& stretches = o.strip.stretches;
  out.hazards = hazards_in(o.grid, o.strip, {stretches[o.gap - 1].to, stretches[o.gap].from}, around);
  const auto refuse = [&out](std::string why) {
    out.why_not = std::move(why);
    return out;
  };
  if (out.hazards.size() != 1) return refuse("there are several obstacles");
  const TurnedHazard& hazard = around.hazards[out.hazards.front()];
  if (!(hazard.box.width() < threshold_m)) return refuse("the obstacle is too wide across the track");
  if (!hazard.round && !convex(hazard.outline)) return refuse("the obstacle's buffer has a kink");

  const double half = 0.5 * o.width_m, radius = std::max(o.radius_m, half);
  const double centre = o.grid.centre(o.strip.index);
  const bool left = farthest_left(hazard, centre) <= farthest_right(hazard, centre);
  const DetourFrame frame{centre, left ? Passing::kLeft : Passing::kRight};
  const std::optional<Path> path = unrounded_detour_path(buffer_of(hazard, frame, half, radius), radius);
  out.detour.side = frame.side;
  if (!path) return refuse("the obstacle has no side to pass on");
  out.detour.path = frame.to_strip(*path);
  out.detour.from = out.detour.path.front().from.y;
  out.detour.to = out.detour.path.back().to.y;
  out.detour.length_m = length(out.detour.path);
  return refuse(fault_in_track(o, out.detour, around));
}

}  // namespace tramline
