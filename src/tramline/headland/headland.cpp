#include "tramline/headland/headland.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/headland/ceded_to_tracks.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/pass_rings.h"
#include "tramline/headland/pass_tally.h"
#include "tramline/headland/plain/plain_headland.h"

namespace tramline {
namespace {

Region body_behind(const Field& field, const Region& land, const std::vector<Boundary>& boundaries,
                   double width_m) {
  Region behind = land_behind_headlands(boundaries, width_m);
  const Region inside = land_inside_obstacles(field, boundaries);
  if (!inside.empty()) behind = unite(behind, inside);
  if (boundaries.front().passes > 0 && field.obstacles.empty()) return behind;
  return intersection(land, behind);
}

/// The land where tracks may end in any direction, a width from every boundary that has passes, and where
/// they may also reach over the edge of their ground, a width from every boundary.
ClearLand clear_of_boundaries(std::vector<Boundary> boundaries, double width_m) {
  bool all = true;
  for (Boundary& boundary : boundaries) {
    all = all && boundary.passes > 0;
    boundary.passes = std::min(boundary.passes, 1);
  }
  ClearLand out;
  out.for_track_ends = land_behind_headlands(boundaries, width_m);
  for (Boundary& boundary : boundaries) boundary.passes = 1;
  out.for_track_sides = all ? out.for_track_ends : land_behind_headlands(boundaries, width_m);
  return out;
}

void leave_to_tracks(const Field& field, const Region& land, const std::vector<Boundary>& boundaries,
                     const HeadlandTerms& terms, HeadlandAndBody& out) {
  const double w = terms.width_m, least_m = std::max(terms.min_length_m, 2 * w);
  if (out.uncovered_m2 <= 0) return;
  const Region ceded = ceded_to_tracks(out, clear_of_boundaries(boundaries, w), w, least_m);
  if (ceded.empty()) return;
  out.body = unite(out.body, ceded);
  out.ground = difference(land, out.body);
  tally_passes(obstacle_shapes(field, ObstacleKind::kPassable), w, out);
}

int deepest(const std::vector<Boundary>& boundaries) {
  int out = 0;
  for (const Boundary& boundary : boundaries) out = std::max(out, boundary.passes);
  return out;
}

bool leaves_body(const Field& field, double width_m, int passes) {
  const auto boundaries = boundaries_of(field, {width_m, 0, passes, {}});
  return !body_behind(field, body_of(field), boundaries, width_m).empty();
}

}  // namespace

HeadlandAndBody headland_of(const Field& field, const HeadlandTerms& terms) {
  if (terms.construction == HeadlandConstruction::kPlain) return plain_headland_of(field, terms);
  const std::vector<Boundary> boundaries = boundaries_of(field, terms);
  const Region land = body_of(field);
  HeadlandAndBody out;
  out.obstacle_passes = terms.obstacle_passes;
  const int most = deepest(boundaries);
  if (most == 0) {
    out.body = land;
    return out;
  }
  out.body = body_behind(field, land, boundaries, terms.width_m);
  out.ground = difference(land, out.body);
  const Region passable = obstacle_shapes(field, ObstacleKind::kPassable);
  for (int number = 1; number <= most; ++number) {
    std::vector<HeadlandPass> rings =
        pass_rings(boundaries, terms, number, {out.ground, passable, terms.width_m}, out.passes);
    out.passes.insert(out.passes.end(), std::make_move_iterator(rings.begin()),
                      std::make_move_iterator(rings.end()));
  }
  tally_passes(passable, terms.width_m, out);
  leave_to_tracks(field, land, boundaries, terms, out);
  return out;
}

int most_passes(const Field& field, double width_m) {
  const Box reach = bounds(field.outer);
  int fits = 0, too_many = 1 + static_cast<int>(0.5 * std::min(reach.width(), reach.height()) / width_m);
  while (too_many - fits > 1) {
    const int middle = fits + (too_many - fits) / 2;
    (leaves_body(field, width_m, middle) ? fits : too_many) = middle;
  }
  return fits;
}

}  // namespace tramline
