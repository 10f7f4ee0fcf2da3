#include "tramline/check/turning/land_parts.h"

#include <algorithm>
#include <limits>

#include "tramline/check/turning/turning_ground.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// Land that is narrower than the machine by twice this is held for wide enough, m.
constexpr double kNarrower_m = 0.05;

double distance_to(const Polygon& land, Point p) {
  if (contains(land, p)) return 0;
  double out_m = std::numeric_limits<double>::infinity();
  const auto along = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      out_m = std::min(out_m, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  };
  along(land.outer);
  for (const Ring& hole : land.holes) along(hole);
  return out_m;
}

}  // namespace

LandParts::LandParts(const Plan& plan) {
  const std::optional<double> beyond_m = land_beyond_m(plan);
  if (!beyond_m) return;
  const Region field{{plan.field.outer, {}}};
  Region all = *beyond_m > 0 ? buffered(field, *beyond_m) : field;
  Region obstacles, crossed;
  for (const Obstacle& obstacle : plan.field.obstacles) {
    obstacles.push_back(obstacle.shape);
    if (obstacle.kind == ObstacleKind::kPassable) crossed.push_back(obstacle.shape);
  }
  if (!obstacles.empty()) all = difference(all, unite(obstacles));
  all.insert(all.end(), crossed.begin(), crossed.end());
  if (!crossed.empty()) all = unite(all);
  const double aside_m =
      0.5 * std::max(plan.machine.width_m, plan.machine.turning.vehicle_width_m) - kNarrower_m;
  places_ = aside_m > 0 ? buffered(all, -aside_m) : all;
}

std::size_t LandParts::part_of(Point axle) const {
  std::size_t out = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places_.size() && least_m > 0; ++i) {
    const double off_m = distance_to(places_[i], axle);
    if (off_m >= least_m) continue;
    least_m = off_m;
    out = i;
  }
  return out;
}

}  // namespace tramline::check
