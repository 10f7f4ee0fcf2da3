#include "tramline/headland/edges/chain_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/clear_stretches.h"
#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/driven_on.h"
#include "tramline/headland/edges/chain_wall.h"
#include "tramline/headland/path_stretch.h"
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

/// Marks the centre line that parts the end of a run from its beginning.
constexpr std::size_t kNoBoundary = std::numeric_limits<std::size_t>::max();

/// The centre lines along a run. Between the end of one that is not closed and its beginning lies one far
/// away, too long to be left out.
std::vector<CentreLine> centre_lines_of(const OffsetRun& run, double radius_m, double most_skipped_m) {
  constexpr double kFarAway_m = 1e6;
  std::vector<CentreLine> out = centre_lines_along({run.pieces}, radius_m);
  if (run.closed || out.empty()) return out;
  const Point far{bounds(run.pieces.front().segment.from, run.pieces.back().segment.to).max_x + kFarAway_m,
                  0};
  out.back().straight_on = false;
  out.back().next = out.size();
  out.push_back({offset_line(far, far + Point{2 * most_skipped_m, 0}), kNoBoundary, 0, false});
  return out;
}

/// An open path whose ends meet at an angle ends a little earlier: taken for a closed one it would be joined
/// there, with a kink.
Path not_closed(Path path) {
  constexpr double kEarlier_m = 0.01;
  if (path.empty() || distance(path.front().from, path.back().to) > kSamePlace_m) return path;
  const double meet = dot(direction_at_end(path.back()), direction_at_start(path.front()));
  if (meet > 1 - kSamePlace_m) return path;
  return stretch_of(path, 0, length(path) - kEarlier_m);
}

/// The lines beside the chain that the machine can follow.
std::vector<Path> paths_beside(const TurningRoom& room, const EdgeChain& chain, double width_m) {
  const ArcFits fits = [&](Point centre, Point before, Point after) {
    return keeps_off(turn_about(centre, room.radius_m, before, after), room.offset_boundaries);
  };
  const double most_skipped_m = room.radius_m + width_m;
  std::vector<Path> out;
  for (const OffsetRun& run : offset_runs(room, chain)) {
    const std::vector<CentreLine> centre_lines = centre_lines_of(run, room.radius_m, most_skipped_m);
    if (centre_lines.empty()) continue;
    const RollingCirclePaths ways = rolling_circle_paths(centre_lines, 0, fits, most_skipped_m);
    if (ways.closed) out.push_back(closed_path(*ways.closed, room.radius_m));
    for (const OffsetRing& way : ways.open)
      if (way.front().offset_boundary != kNoBoundary)
        out.push_back(not_closed(open_path(way, room.radius_m)));
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
  return {fence_at(first_end(scene.to_follow.chain), scene),
          fence_at(last_end(scene.to_follow.chain), scene)};
}

/// So far before the end of its chain a path is cut, to go straight on: behind it turns about the end.
constexpr double kBeforeEnd_m = 1e-3;

/// The parts of the path beside the chain whose swaths are in the field.
std::vector<Path> stretches_beside(const Path& path, const ChainScene& scene) {
  std::vector<OffsetBoundary> in_the_way{
      {scene.boundaries.front().ring, 0.5 * scene.width_m() - kJustFits_m}};
  for (Ring& fence : fences(scene)) in_the_way.push_back({std::move(fence), kBeforeEnd_m});
  for (const Boundary& obstacle : scene.obstacles)
    in_the_way.push_back(
        {obstacle.ring, pass_distance_m(obstacle, scene.number, scene.width_m()) - kJustFits_m});
  return clear_stretches(path, in_the_way, 0.25 * scene.width_m());
}

/// What no swath may run over as it goes straight on, besides land worked before.
std::vector<SwathLimit> limits_of(const ChainScene& scene) {
  std::vector<SwathLimit> out;
  // Chords are no part of it: a swath beside it comes nearer than it should by slack alone.
  out.push_back({scene.boundaries.front().ring, 0, 2 * kNearerPass_m});
  for (const Boundary& obstacle : scene.obstacles)
    out.push_back({obstacle.ring,
                   headland_depth_m(obstacle, std::min(scene.number - 1, obstacle.passes), scene.width_m())});
  const std::vector<Ring> at_ends = fences(scene);
  if (scene.to_follow.ground.first == ChainEnding::kFlat) out.push_back({at_ends.front(), 0});
  if (scene.to_follow.ground.last == ChainEnding::kFlat) out.push_back({at_ends.back(), 0});
  return out;
}

/// The share of a part of a path that is ground worked for the first time, of the area it works.
double fresh_share(const Path& part, const GroundToWork& to_work, const std::vector<HeadlandPass>& before) {
  const double all_m2 = to_work.width_m * length(part);
  const double fresh_m2 =
      (worth_m2({part}, to_work, before) + kEndsOfPass_m2 + all_m2) / (1 + kMissedToDoubled);
  return fresh_m2 / all_m2;
}

/// A path whose last part, from `core_m` on, was added to a pass as it went straight on.
class Extended {
 public:
  Extended(const Path& path, double core_m, const GroundToWork& to_work,
           const std::vector<HeadlandPass>& before)
      : path_(path), length_m_(length(path)), core_m_(core_m), to_work_(to_work), before_(before) {}

  /// The path up to where going on is worth most: at most to the first land that is worked already. Its
  /// beginning is not judged.
  Path as_far_as_it_pays() const {
    double at_m = std::max(0.5 * core_m_, core_m_ - kJudged_widths * to_work_.width_m);
    double sum_m2 = 0, most_m2 = 0, best_m = at_m;
    while (at_m < length_m_) {
      const double to_m = std::min(length_m_, at_m + 0.25 * to_work_.width_m);
      const double share = share_of(at_m, to_m);
      if (share < kWorked_share) break;
      sum_m2 += worth(share) * (to_m - at_m);
      at_m = to_m;
      if (sum_m2 < most_m2) continue;
      most_m2 = sum_m2;
      best_m = at_m;
    }
    if (best_m >= length_m_) return path_;
    const double end_m = best_m + more_m(best_m, std::min(length_m_, best_m + 0.25 * to_work_.width_m));
    return end_m <= 0 ? Path{} : stretch_of(path_, 0, end_m);
  }

 private:
  static constexpr double kJudged_widths = 4, kWorked_share = 0.02;

  static double worth(double share) { return (1 + kMissedToDoubled) * share - 1; }
  double share_of(double from_m, double to_m) const {
    const Path part = stretch_of(path_, from_m, to_m);
    return part.empty() ? 0 : fresh_share(part, to_work_, before_);
  }
  /// How far it pays into the next step.
  double more_m(double from_m, double to_m) const {
    constexpr int kHalvings = 16;
    constexpr double kSlice_m = 1e-3;
    double pays_m = from_m, other_m = to_m;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle_m = 0.5 * (pays_m + other_m);
      const bool pays = worth(share_of(std::max(0.0, middle_m - kSlice_m), middle_m)) > 0;
      (pays ? pays_m : other_m) = middle_m;
    }
    return pays_m - from_m;
  }

  const Path& path_;
  double length_m_;
  double core_m_;
  const GroundToWork& to_work_;
  const std::vector<HeadlandPass>& before_;
};

/// The path driven straight on at its end, up to land worked before.
Path driven_on_over_fresh_land(const Path& path, const std::vector<SwathLimit>& limits,
                               const ChainScene& scene, const GroundToWork& to_work,
                               const std::vector<HeadlandPass>& before) {
  const Path farther =
      driven_on(path, limits, {scene.width_m(), tightest_turn_m(scene.terms), scene.farthest_on_m()});
  return Extended(farther, length(path), to_work, before).as_far_as_it_pays();
}

/// The same at both ends; where they would cross, the first one ends at the second. Empty where nothing is
/// left.
Path driven_straight_on(const Path& path, const ChainScene& scene, const GroundToWork& to_work,
                        std::vector<HeadlandPass> before) {
  if (distance(path.front().from, path.back().to) < kSamePlace_m) return path;
  const std::vector<SwathLimit> limits = limits_of(scene);
  const Path one = driven_on_over_fresh_land(path, limits, scene, to_work, before);
  if (one.empty()) return {};
  if (const double core_m = length(path); length(one) > core_m + kNoRun_m)
    before.push_back({stretch_of(one, core_m, length(one)), scene.number, true, {}});
  const Path both = driven_on_over_fresh_land(reversed(one), limits, scene, to_work, before);
  return both.empty() ? Path{} : reversed(both);
}

/// The whole path where what it works in vain is little, else its parts that are worth driving.
std::vector<Path> worthy_parts(const Path& path, const ChainScene& scene, const GroundToWork& to_work,
                               const std::vector<HeadlandPass>& before) {
  constexpr double kLeastFresh_share = 0.5;
  if (path.empty() || length(path) < scene.least_length_m()) return {};
  const double share = fresh_share(path, to_work, before);
  const double in_vain_m2 = (1 - share) * scene.width_m() * length(path);
  if (in_vain_m2 < kEndsOfPass_m2 && share > kLeastFresh_share) return {path};
  return worth_driving(path, to_work, before, scene.least_length_m());
}

double distance_between(const Path& path, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path)
    for (std::size_t i = 0; i < ring.size(); ++i)
      out = std::min(out, distance_to_edge(segment, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

/// Whether some of a part of a path that was driven straight on lies on the stretch beside the chain. What
/// lies straight on alone follows no edge.
bool is_beside_chain(const Path& part, const Path& stretch) {
  constexpr double kPlaces = 50;
  const double length_m = length(part);
  for (double i = 0.5; i < kPlaces; ++i) {
    const Point at = stretch_of(part, i / kPlaces * length_m, length_m).front().from;
    for (const PathSegment& segment : stretch)
      if (distance_to_edge(segment, at, at) < kSamePlace_m) return true;
  }
  return false;
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
  const TurningRoom room =
      room_beside(to_follow.chain, scene.obstacles, terms.width_m, number, tightest_turn_m(terms));
  Region shapes;
  for (const Boundary& obstacle : scene.obstacles) shapes.push_back({reversed(obstacle.ring), {}});
  const Region ground = shapes.empty() ? to_follow.ground.land : difference(to_follow.ground.land, shapes);
  const GroundToWork to_work{ground, passable, terms.width_m};
  std::vector<HeadlandPass> all = before;
  std::vector<Path> stretches;
  for (const Path& path : paths_beside(room, to_follow.chain, terms.width_m))
    for (Path& stretch : stretches_beside(path, scene)) stretches.push_back(std::move(stretch));
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Path& a, const Path& b) { return length(a) > length(b); });
  for (const Path& stretch : stretches)
    for (const Path& part :
         worthy_parts(not_closed(driven_straight_on(stretch, scene, to_work, all)), scene, to_work, all))
      for (const Path& piece : parted_where_it_meets_itself(part))
        if (length(piece) >= scene.least_length_m() && is_beside_chain(piece, stretch))
          all.push_back(pass_beside(not_closed(piece), scene));
  return {all.begin() + static_cast<std::ptrdiff_t>(before.size()), all.end()};
}

}  // namespace tramline
