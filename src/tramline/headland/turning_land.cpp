#include "tramline/headland/turning_land.h"

#include "tramline/headland/tolerances.h"
#include "tramline/headland/wide_corners.h"

namespace tramline {

TurningLand turning_land(const std::vector<Boundary>& boundaries, double width_m, int number,
                         double radius_m) {
  TurningLand out;
  out.radius_m = radius_m;
  bool any_tight = false;
  for (const Boundary& boundary : boundaries) {
    const double distance_m = pass_distance_m(boundary, number, width_m) - kJustFits_m;
    out.shores.push_back({boundary.ring, distance_m});
    any_tight = any_tight || distance_m < radius_m;
  }
  if (any_tight) out.discs = wide_corners(level_rings(out.shores), radius_m);
  for (Shore& shore : out.shores) shore.round_corners = shore.distance_m >= radius_m;
  return out;
}

std::vector<LevelRing> levels(const TurningLand& land) { return level_rings(land.shores, land.discs); }

std::vector<LevelRing> turning_centres(const TurningLand& land) {
  TurningLand out = land;
  for (Shore& shore : out.shores) shore.distance_m += land.radius_m;
  for (ShoreDisc& disc : out.discs) disc.radius_m += land.radius_m;
  return level_rings(out.shores, out.discs);
}

}  // namespace tramline
