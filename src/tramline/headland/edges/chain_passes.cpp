#include "tramline/headland/edges/chain_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/clear_stretches.h"
#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/edges/chain_wall.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/headland/ring_groups.h"
#include "tramline/headland/rolling_circle_path.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// The input of one pass along one chain.
struct ChainScene {
  const ChainToFollow& to_follow;
  const std::vector<Boundary>& boundaries;  ///< the field's outer ring first
  const HeadlandTerms& terms;
  int number;
  std::vector<Boundary> obstacles;  ///< those near the chain

  double width_m() const { return terms.width_m; }
  double least_length_m() const { return std::max(terms.min_length_m, terms.width_m); }
  /// A pass that goes straight on beyond its chain reaches the boundary by then.
  double farthest_on_m() const { return 2 * (number + 1) * terms.width_m; }
};

std::vector<Boundary> obstacles_near(const ChainToFollow& to_follow, const std::vector<Boundary>& boundaries,
                                     const HeadlandTerms& terms, int number) {
  std::vector<Boundary> out;
  const Box reach = bounds(to_follow.ground.land).grown(number * terms.width_m + 2 * tightest_turn_m(terms));
  for (std::size_t i = 1; i < boundaries.size(); ++i)
    if (intersects(reach, bounds(boundaries[i].ring))) out.push_back(boundaries[i]);
  return out;
}

/// The lines that the machine can follow all round the chain's wall.
std::vector<Path> paths_round(const TurningRoom& room, double width_m) {
  const std::vector<CentreLine> centre_lines = centre_lines_along(offset_lines(room), room.radius_m);
  const ArcFits fits = [&](Point centre, Point before, Point after) {
    return keeps_off(turn_about(centre, room.radius_m, before, after), room.offset_boundaries);
  };
  std::vector<Path> out;
  for (std::size_t first = 0, last = 0; first < centre_lines.size(); first = last) {
    bool own = false;
    do {
      own = own || centre_lines[last].offset_boundary == 0;
      ++last;
    } while (last < centre_lines.size() && centre_lines[last - 1].next == last);
    if (!own) continue;
    RollingCirclePaths ways = rolling_circle_paths(centre_lines, first, fits, room.radius_m + width_m);
    if (ways.closed) out.push_back(closed_path(*ways.closed, room.radius_m));
    for (const OffsetRing& way : ways.open) out.push_back(open_path(way, room.radius_m));
  }
  std::erase_if(out, [](const Path& path) { return path.empty(); });
  return out;
}

/// A thin clockwise ring across the way of the pass at the end of its chain.
Ring fence_at(const ChainEnd& end, const ChainScene& scene) {
  constexpr double kThin_m = 1e-3, kBesideTheNext = 0.9;
  const Point near = end.at + (scene.number - kBesideTheNext) * scene.width_m() * end.inland;
  const Point far = end.at + (scene.number + 1) * scene.width_m() * end.inland;
  Ring out{near, far, far + kThin_m * end.ahead, near + kThin_m * end.ahead};
  return signed_area(out) > 0 ? reversed(out) : out;
}

std::vector<Ring> fences(const ChainScene& scene) {
  return {fence_at(first_end(scene.to_follow.chain), scene), fence_at(last_end(scene.to_follow.chain), scene)};
}

/// The parts of the path beside the chain whose swaths are in the field.
std::vector<Path> stretches_beside(const Path& path, const ChainScene& scene, double end_m) {
  std::vector<OffsetBoundary> in_the_way{
      {scene.boundaries.front().ring, 0.5 * scene.width_m() - kJustFits_m}};
  for (Ring& fence : fences(scene)) in_the_way.push_back({std::move(fence), end_m});
  for (const Boundary& obstacle : scene.obstacles)
    in_the_way.push_back({obstacle.ring, pass_distance_m(obstacle, scene.number, scene.width_m()) - kJustFits_m});
  return clear_stretches(path, in_the_way, 0.25 * scene.width_m());
}

void append_swath(const Path& path, double width_m, std::vector<SwathLimit>& limits) {
  for (const Ring& ring : rings_of(pass_ground_parts(path, width_m, kLayerSagitta)))
    limits.push_back({ring, 0});
}

/// What no swath may run over as it goes straight on.
std::vector<SwathLimit> limits_of(const ChainScene& scene, const std::vector<HeadlandPass>& before) {
  std::vector<SwathLimit> out;
  out.push_back({scene.boundaries.front().ring, 0});
  for (const Boundary& obstacle : scene.obstacles)
    out.push_back(
        {obstacle.ring, std::min(scene.number - 1, obstacle.passes) * scene.width_m()});
  const std::vector<Ring> at_ends = fences(scene);
  if (scene.to_follow.ground.first == ChainEnding::kFlat) out.push_back({at_ends.front(), 0});
  if (scene.to_follow.ground.last == ChainEnding::kFlat) out.push_back({at_ends.back(), 0});
  const Box reach = bounds(scene.to_follow.ground.land).grown(scene.farthest_on_m());
  for (const HeadlandPass& pass : before)
    if (intersects(reach, reach_of(pass.path, scene.width_m()))) append_swath(pass.path, scene.width_m(), out);
  return out;
}

/// The path driven straight on at both ends; where they would cross, the first one ends at the second.
Path driven_straight_on(const Path& path, std::vector<SwathLimit> limits, const ChainScene& scene) {
  if (distance(path.front().from, path.back().to) < kSamePlace_m) return path;
  Path out = driven_on(path, limits, scene.width_m(), scene.farthest_on_m());
  const double more_m = length(out) - length(path);
  if (more_m > kNoRun_m) append_swath({out.back()}, scene.width_m(), limits);
  return reversed(driven_on(reversed(out), limits, scene.width_m(), scene.farthest_on_m()));
}

/// The whole path where what it works in vain is little, else its parts that are worth driving.
std::vector<Path> worthy_parts(const Path& path, const ChainScene& scene, const GroundToWork& to_work,
                               const std::vector<HeadlandPass>& before) {
  constexpr double kLeastFresh_share = 0.5;
  if (length(path) < scene.least_length_m()) return {};
  const double all_m2 = scene.width_m() * length(path);
  const double fresh_m2 =
      (worth_m2({path}, to_work, before) + kEndsOfPass_m2 + all_m2) / (1 + kMissedToDoubled);
  if (all_m2 - fresh_m2 < kEndsOfPass_m2 && fresh_m2 > kLeastFresh_share * all_m2) return {path};
  return worth_driving(path, to_work, before, scene.least_length_m());
}

double distance_between(const Path& path, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path)
    for (std::size_t i = 0; i < ring.size(); ++i)
      out = std::min(out, distance_to_edge(segment, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

HeadlandPass pass_beside(const Path& path, const ChainScene& scene) {
  HeadlandPass out{path, scene.number, true, {}};
  for (const Boundary& obstacle : scene.obstacles) {
    if (obstacle.passes < scene.number) continue;
    const double near_m =
        pass_distance_m(obstacle, scene.number, scene.width_m()) + tightest_turn_m(scene.terms);
    if (distance_between(path, obstacle.ring) <= near_m) out.obstacles.push_back(*obstacle.obstacle);
  }
  return out;
}

}  // namespace

std::vector<HeadlandPass> passes_along(const ChainToFollow& to_follow,
                                       const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                       int number, const Region& passable,
                                       const std::vector<HeadlandPass>& before) {
  const ChainScene scene{to_follow, boundaries, terms, number,
                         obstacles_near(to_follow, boundaries, terms, number)};
  const RoomBeside beside =
      room_beside(to_follow.chain, scene.obstacles, terms.width_m, number, tightest_turn_m(terms));
  Region shapes;
  for (const Boundary& obstacle : scene.obstacles) shapes.push_back({reversed(obstacle.ring), {}});
  const Region ground = shapes.empty() ? to_follow.ground.land : difference(to_follow.ground.land, shapes);
  const GroundToWork to_work{ground, passable, terms.width_m};
  std::vector<HeadlandPass> all = before;
  std::vector<Path> stretches;
  for (const Path& path : paths_round(beside.room, terms.width_m))
    for (Path& stretch : stretches_beside(path, scene, beside.end_m)) stretches.push_back(std::move(stretch));
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Path& a, const Path& b) { return length(a) > length(b); });
  for (const Path& stretch : stretches)
    for (const Path& part :
         worthy_parts(driven_straight_on(stretch, limits_of(scene, all), scene), scene, to_work, all))
      for (const Path& piece : parted_where_it_meets_itself(part))
        if (length(piece) >= scene.least_length_m()) all.push_back(pass_beside(piece, scene));
  return {all.begin() + static_cast<std::ptrdiff_t>(before.size()), all.end()};
}

}  // namespace tramline
