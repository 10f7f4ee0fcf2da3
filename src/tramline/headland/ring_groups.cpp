#include "tramline/headland/ring_groups.h"

#include <algorithm>

#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/passages/narrow_passages.h"
#include "tramline/headland/passages/rings_compared.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// Whether any of the ring follows a boundary that has the pass.
bool follows_own(const OffsetRing& ring, const std::vector<Boundary>& boundaries, int number) {
  return std::any_of(ring.begin(), ring.end(), [&](const OffsetPiece& piece) {
    return boundaries[piece.offset_boundary].passes >= number;
  });
}

HeadlandPass pass_along(const OffsetRing& ring, const std::vector<Boundary>& boundaries, int number,
                        double radius_m) {
  HeadlandPass pass{closed_path(ring, radius_m), number, false, {}};
  for (const OffsetPiece& piece : ring) {
    if (const auto obstacle = boundaries[piece.offset_boundary].obstacle)
      pass.obstacles.push_back(*obstacle);
    else
      pass.around_field = true;
  }
  if (const std::vector<Point> line = chords(pass.path, 1.0); signed_area(line) < 0)
    for (const Boundary& boundary : boundaries)
      if (boundary.obstacle && contains(line, boundary.ring.front()))
        pass.obstacles.push_back(*boundary.obstacle);
  std::sort(pass.obstacles.begin(), pass.obstacles.end());
  pass.obstacles.erase(std::unique(pass.obstacles.begin(), pass.obstacles.end()), pass.obstacles.end());
  return pass;
}

/// Distance of the centre line of another boundary's pass from this one, m: its swath may touch the swath
/// here, or the last one, or the obstacle.
double room_m(const Boundary& boundary, int number, double width_m) {
  return pass_distance_m(boundary, number, width_m) + (boundary.passes >= number ? width_m : 0);
}

bool comes_near(const Path& path, const std::vector<Box>& reaches, const Ring& ring, double distance_m) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const Box edge = bounds(a, b);
    for (std::size_t k = 0; k < path.size(); ++k)
      if (intersects(edge, reaches[k]) && distance_to_edge(path[k], a, b) < distance_m) return true;
  }
  return false;
}

/// Whether a pass of the group comes too near to the boundary or is on its wrong side.
bool disturbs(const RingGroup& group, const Boundary& boundary, int number, double width_m) {
  if (!boundary.obstacle && boundary.passes < number) return false;  // passes end there
  const double room = room_m(boundary, number, width_m);
  const Box box = bounds(boundary.ring);
  const bool land_inside = signed_area(boundary.ring) > 0;
  return std::any_of(group.passes.begin(), group.passes.end(), [&](const HeadlandPass& pass) {
    if (contains(boundary.ring, pass.path.front().from) != land_inside) return true;
    return intersects(reach_of(pass.path, 2 * room), box) &&
           comes_near(pass.path, reaches_of(pass.path, 2 * room), boundary.ring, room - kNearerGroup_m);
  });
}

/// The input of groups.
struct GroupScene {
  const std::vector<Boundary>& boundaries;
  const HeadlandTerms& terms;
  int number;
  const GroundToWork& to_work;
  const std::vector<HeadlandPass>& before;

  std::vector<HeadlandPass> rings(const std::vector<std::size_t>& members) const {
    return rings_round(members, boundaries, terms, number, to_work, before);
  }
};

/// Joins the first two groups of which one disturbs the other; false where there are none.
bool merge_first(std::vector<RingGroup>& groups, const GroupScene& scene) {
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = 0; j < groups.size(); ++j) {
      const auto& others = groups[j].members;
      if (i == j || std::none_of(others.begin(), others.end(), [&](std::size_t k) {
            return disturbs(groups[i], scene.boundaries[k], scene.number, scene.terms.width_m);
          }))
        continue;
      RingGroup& kept = groups[std::min(i, j)];
      const RingGroup& gone = groups[std::max(i, j)];
      kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
      std::sort(kept.members.begin(), kept.members.end());
      kept.passes = scene.rings(kept.members);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
      return true;
    }
  return false;
}

}  // namespace

double tightest_turn_m(const HeadlandTerms& terms) { return std::max(terms.radius_m, 0.5 * terms.width_m); }

std::vector<HeadlandPass> rings_round(const std::vector<std::size_t>& indices,
                                      const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                      int number, const GroundToWork& to_work,
                                      const std::vector<HeadlandPass>& before) {
  const double radius_m = tightest_turn_m(terms);
  std::vector<Boundary> members;
  for (const std::size_t i : indices) members.push_back(boundaries[i]);
  if (std::none_of(members.begin(), members.end(), [&](const Boundary& b) { return b.passes >= number; }))
    return {};
  const auto passes_along = [&](const std::vector<OffsetRing>& rings) {
    std::vector<HeadlandPass> out;
    for (const OffsetRing& ring : rings)
      if (follows_own(ring, members, number)) out.push_back(pass_along(ring, members, number, radius_m));
    return out;
  };
  const TurningRoom land = turning_room(members, terms.width_m, number, radius_m);
  const auto better = [&](const std::vector<OffsetRing>& rings, const std::vector<OffsetRing>& than) {
    return are_better(passes_along(rings), passes_along(than), to_work, before);
  };
  return passes_along(joined_through_narrow_passages(turning_centres(land), land, better));
}

std::vector<RingGroup> ring_groups(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                   int number, const GroundToWork& to_work,
                                   const std::vector<HeadlandPass>& before) {
  const GroupScene scene{boundaries, terms, number, to_work, before};
  std::vector<RingGroup> groups(boundaries.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i].members = {i};
    groups[i].passes = scene.rings(groups[i].members);
  }
  while (merge_first(groups, scene)) {
  }
  return groups;
}

}  // namespace tramline
