#include "tramline/headland/turning_room.h"

#include "tramline/headland/tolerances.h"
#include "tramline/headland/wide_corners.h"

namespace tramline {

TurningRoom turning_room(const std::vector<Boundary>& boundaries, double width_m, int number,
                         double radius_m) {
  TurningRoom out;
  out.radius_m = radius_m;
  bool any_tight = false;
  for (const Boundary& boundary : boundaries) {
    const double distance_m = pass_distance_m(boundary, number, width_m) - kJustFits_m;
    out.offset_boundaries.push_back({boundary.ring, distance_m});
    any_tight = any_tight || distance_m < radius_m;
  }
  if (any_tight) {
    const std::vector<OffsetRing> rings = offset_rings(out.offset_boundaries);
    out.discs = wide_corners(rings, rings, radius_m);
  }
  for (OffsetBoundary& offset_boundary : out.offset_boundaries)
    offset_boundary.round_corners = offset_boundary.distance_m >= radius_m;
  return out;
}

std::vector<OffsetRing> offset_lines(const TurningRoom& land) {
  return offset_rings(land.offset_boundaries, land.discs);
}

std::vector<OffsetRing> turning_centres(const TurningRoom& land) {
  TurningRoom out = land;
  for (OffsetBoundary& offset_boundary : out.offset_boundaries) offset_boundary.distance_m += land.radius_m;
  for (OffsetDisc& disc : out.discs) disc.radius_m += land.radius_m;
  return offset_rings(out.offset_boundaries, out.discs);
}

}  // namespace tramline
