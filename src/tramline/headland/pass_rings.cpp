#include "tramline/headland/pass_rings.h"

#include <algorithm>

#include "tramline/geometry/layered_area.h"
#include "tramline/headland/closed_path.h"
#include "tramline/headland/necks.h"
#include "tramline/headland/sound_rings.h"

namespace tramline {
namespace {

/// How much of a ring follows boundaries that have the pass, and boundaries whose passes are used up, m.
/// Those without headland are on neither side: they have to be gone round in any case.
bool worth_driving(const LevelRing& ring, const std::vector<Boundary>& boundaries, int number) {
  double own = 0, used_up = 0;
  for (const LevelPiece& piece : ring) {
    const int passes = boundaries[static_cast<std::size_t>(piece.shore)].passes;
    if (passes >= number)
      own += length(piece.segment);
    else if (passes > 0)
      used_up += length(piece.segment);
  }
  return own > 0 && own >= used_up;
}

HeadlandPass pass_along(const LevelRing& ring, const std::vector<Boundary>& boundaries, int number,
                        double radius_m) {
  HeadlandPass pass{closed_path(ring, radius_m), number, false, {}};
  for (const LevelPiece& piece : ring) {
    const int obstacle = boundaries[static_cast<std::size_t>(piece.shore)].obstacle;
    if (obstacle < 0)
      pass.around_field = true;
    else
      pass.obstacles.push_back(obstacle);
  }
  if (const std::vector<Point> line = chords(pass.path, 1.0); signed_area(line) < 0)
    for (const Boundary& boundary : boundaries)
      if (boundary.obstacle >= 0 && contains(line, boundary.ring.front()))
        pass.obstacles.push_back(boundary.obstacle);
  std::sort(pass.obstacles.begin(), pass.obstacles.end());
  pass.obstacles.erase(std::unique(pass.obstacles.begin(), pass.obstacles.end()), pass.obstacles.end());
  return pass;
}

/// How far the centre line of another boundary's pass keeps from this one, m: its swath may touch the swath
/// here, or the last one, or the obstacle.
double room_m(const Boundary& boundary, int number, double width_m) {
  return pass_distance_m(boundary, number, width_m) + (boundary.passes >= number ? width_m : 0);
}

bool comes_near(const Path& path, const std::vector<Box>& reaches, const Ring& ring, double distance_m) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    Box edge;
    edge.extend(a);
    edge.extend(b);
    for (std::size_t k = 0; k < path.size(); ++k)
      if (intersects(edge, reaches[k]) && distance_to_edge(path[k], a, b) < distance_m) return true;
  }
  return false;
}

/// Boundaries that are driven round together, and the passes that makes.
struct Group {
  std::vector<std::size_t> members;  ///< increasing
  std::vector<HeadlandPass> passes;
};

/// What rings leave of the ground and what they work elsewhere or again, but for a constant, m²: Σ w·L less
/// twice what they are the first to work of it.
double missed_and_doubled_m2(const std::vector<HeadlandPass>& rings, const Worked& before, double width_m) {
  if (rings.empty()) return 0;
  RisingCurves curves;
  Box window;
  double worked_m2 = 0;
  for (const HeadlandPass& ring : rings) {
    window.extend(reach_of(ring.path, width_m));
    worked_m2 += width_m * length(ring.path);
    append_band(ring.path, width_m, Layer::kNew, curves);
  }
  for (const HeadlandPass& pass : before.passes)
    if (intersects(window, reach_of(pass.path, width_m)))
      append_band(pass.path, width_m, Layer::kTaken, curves);
  for (const Ring& ring : rings_of(before.ground)) append_ring(ring, Layer::kBody, window, curves);
  return worked_m2 - 2 * new_area(curves);
}

int meetings_of(const std::vector<HeadlandPass>& rings) {
  std::vector<Path> paths;
  for (const HeadlandPass& ring : rings) paths.push_back(ring.path);
  return meeting_places(paths);
}

void drive_round(Group& group, const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                 int number, const Worked& before) {
  const double radius_m = std::max(terms.radius_m, 0.5 * terms.width_m);
  std::vector<Boundary> members;
  for (const std::size_t i : group.members) members.push_back(boundaries[i]);
  group.passes.clear();
  if (std::none_of(members.begin(), members.end(), [&](const Boundary& b) { return b.passes >= number; }))
    return;
  const auto passes_along = [&](const std::vector<LevelRing>& rings) {
    std::vector<HeadlandPass> out;
    for (const LevelRing& ring : rings)
      if (worth_driving(ring, members, number)) out.push_back(pass_along(ring, members, number, radius_m));
    return out;
  };
  const TurningLand land = turning_land(members, terms.width_m, number, radius_m);
  group.passes = passes_along(through_necks(turning_centres(land), land, [&](const auto& rings) {
    const std::vector<HeadlandPass> passes = passes_along(rings);
    return RingsCost{meetings_of(passes), missed_and_doubled_m2(passes, before, terms.width_m)};
  }));
}

/// Does a pass of the group come too near to the boundary, or is it on its wrong side?
bool disturbs(const Group& group, const Boundary& boundary, int number, double width_m) {
  constexpr double kTouch = 1e-6;  // m
  const double room = room_m(boundary, number, width_m);
  const Box box = bounds(boundary.ring);
  const bool land_inside = signed_area(boundary.ring) > 0;
  return std::any_of(group.passes.begin(), group.passes.end(), [&](const HeadlandPass& pass) {
    if (contains(boundary.ring, pass.path.front().from) != land_inside) return true;
    return intersects(reach_of(pass.path, 2 * room), box) &&
           comes_near(pass.path, reaches_of(pass.path, 2 * room), boundary.ring, room - kTouch);
  });
}

/// Puts together the first two groups one of which disturbs the other; false: there are none.
bool merge_first(std::vector<Group>& groups, const std::vector<Boundary>& boundaries,
                 const HeadlandTerms& terms, int number, const Worked& before) {
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = 0; j < groups.size(); ++j) {
      const auto& others = groups[j].members;
      if (i == j || std::none_of(others.begin(), others.end(), [&](std::size_t k) {
            return disturbs(groups[i], boundaries[k], number, terms.width_m);
          }))
        continue;
      Group& kept = groups[std::min(i, j)];
      const Group& gone = groups[std::max(i, j)];
      kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
      std::sort(kept.members.begin(), kept.members.end());
      drive_round(kept, boundaries, terms, number, before);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
      return true;
    }
  return false;
}

}  // namespace

std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number, const Worked& before) {
  std::vector<Group> groups(boundaries.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i].members = {i};
    drive_round(groups[i], boundaries, terms, number, before);
  }
  while (merge_first(groups, boundaries, terms, number, before)) {
  }
  std::vector<HeadlandPass> out;
  for (const Group& group : groups) out.insert(out.end(), group.passes.begin(), group.passes.end());
  return out;
}

}  // namespace tramline
