#include "tramline/headland/driven_on.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/path/shifted_path.h"

namespace tramline {
namespace {

/// The flat end of a swath that is to be extended.
struct SwathEnd {
  Point at, along;
  double half_m = 0;

  Point local(Point p) const { return {dot(p - at, along), cross(along, p - at)}; }
};

/// How far a swath may go on, m, and by which angle the edge that it then meets with its side leads into it,
/// rad, to the left where positive; 0 where it meets none with a side.
struct FreeRun {
  double by_m = 0;
  double side_turn = 0;
};

/// Of an edge that leads from one corner to another.
double angle_of(Point from, Point to) { return std::atan2(to.y - from.y, to.x - from.x); }

/// Until it meets the ring, at the distance of `most` at most. What touches its end already is not in the
/// way.
FreeRun run_to_edges(const SwathEnd& end, const SwathLimit& limit, FreeRun most) {
  const double half_m = end.half_m - limit.beside_m;
  const Ring& ring = limit.ring;
  FreeRun out = most;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point a = end.local(ring[i]), b = end.local(ring[(i + 1) % ring.size()]);
    if (a.y > b.y) std::swap(a, b);
    if (b.y < -half_m || a.y > half_m || std::max(a.x, b.x) < -kSamePlace_m || std::min(a.x, b.x) > out.by_m)
      continue;
    const auto x_at = [&](double y) { return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x); };
    const double first = a.y < -half_m ? x_at(-half_m) : a.x, last = b.y > half_m ? x_at(half_m) : b.x;
    if (std::max(first, last) < -kSamePlace_m) continue;
    const double meets_m = std::max(0.0, std::min(first, last));
    if (meets_m >= out.by_m) continue;
    out = {meets_m, 0};
    if (a.y < -half_m && first < last) out.side_turn = angle_of(a, b);
    if (b.y > half_m && last < first) out.side_turn = angle_of(b, a);
  }
  return out;
}

/// Distance it may go until its sides or its front come nearer to the ring than `distance_m`, m.
double run_beside_m(const SwathEnd& end, const Ring& ring, double distance_m, double most_m) {
  const auto keeps_off = [&](double run_m) {
    const Point left{0, end.half_m}, right{0, -end.half_m}, on{run_m, 0};
    const PathSegment sides[] = {{left, left + on, 0}, {right, right + on, 0}, {left + on, right + on, 0}};
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const PathSegment& side : sides)
        if (distance_to_edge(side, end.local(ring[i]), end.local(ring[(i + 1) % ring.size()])) <
            distance_m - kBeside_m)
          return false;
    return true;
  };
  if (keeps_off(most_m)) return most_m;
  constexpr int kHalvings = 24;
  double clear_m = 0, other_m = most_m;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (clear_m + other_m);
    (keeps_off(middle_m) ? clear_m : other_m) = middle_m;
  }
  return clear_m;
}

FreeRun free_run(const SwathEnd& end, const std::vector<SwathLimit>& limits, double most_m) {
  FreeRun out{most_m};
  for (const SwathLimit& limit : limits) {
    out = run_to_edges(end, limit, out);
    if (limit.distance_m <= 0) continue;
    const double beside_m = run_beside_m(end, limit.ring, limit.distance_m, out.by_m);
    if (beside_m < out.by_m) out = {beside_m, 0};
  }
  return out;
}

/// By so much, or back along its last line where negative.
void go_on(Path& path, double by_m) {
  const Point end = path.back().to + by_m * direction_at_end(path.back());
  if (path.back().straight())
    path.back().to = end;
  else
    path.push_back({path.back().to, end, 0});
}

/// The path turned along the edge that its swath meets with a side after the run; nullopt where its last line
/// is too short to begin the turn in time. Beside the edge's line, half a width away, runs a line that
/// crosses the path's ½w·tan ½δ before the place where the swath meets the edge.
std::optional<Path> turned_along_edge(Path path, const FreeRun& run, const DrivenOn& how) {
  const double slope = std::tan(0.5 * std::abs(run.side_turn));
  const double tangent_m = how.radius_m * slope;
  const double begin_m = run.by_m - 0.5 * how.width_m * slope - tangent_m;
  const double line_m = path.back().straight() ? length(path.back()) : 0;
  if (line_m + begin_m < kShortestPiece_m) return std::nullopt;
  go_on(path, begin_m);
  const Point heading = direction_at_end(path.back()), from = path.back().to;
  const Point along = std::cos(run.side_turn) * heading + std::sin(run.side_turn) * left_of(heading);
  const double curvature = std::copysign(1 / how.radius_m, run.side_turn);
  path.push_back({from, from + tangent_m * (heading + along), curvature});
  return path;
}

/// Whether the swath of an arc keeps its distance from the boundary with its sides, and has none of it
/// inside.
bool keeps_off(const PathSegment& arc, const SwathLimit& limit, double width_m) {
  const double half_m = 0.5 * width_m - limit.beside_m;
  std::vector<PathSegment> sides;
  for (const double right_m : {-half_m, half_m})
    if (const std::optional<Path> side = shifted({arc}, right_m, kShortestPiece_m))
      sides.push_back(side->front());
  const auto is_inside = [&](Point p) {
    return dot(p - arc.from, direction_at_start(arc)) > 0 && dot(p - arc.to, direction_at_end(arc)) < 0 &&
           distance_to_edge(arc, p, p) < half_m;
  };
  const Ring& ring = limit.ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (is_inside(a)) return false;
    for (const PathSegment& side : sides)
      if (distance_to_edge(side, a, b) <= limit.distance_m) return false;
  }
  return true;
}

/// Whether the swath meets the boundary that it goes along where that bends.
bool meets_bend(const FreeRun& run, Along boundary) {
  return (boundary == Along::kOnTheRight && run.side_turn > kNoCorner_rad) ||
         (boundary == Along::kOnTheLeft && run.side_turn < -kNoCorner_rad);
}

Along reversed(Along boundary) {
  if (boundary == Along::kNone) return boundary;
  return boundary == Along::kOnTheRight ? Along::kOnTheLeft : Along::kOnTheRight;
}

}  // namespace

Path driven_on(Path path, const std::vector<SwathLimit>& limits, const DrivenOn& how) {
  const double start_m = length(path);
  const auto run_of = [&](const Path& one) {
    const SwathEnd end{one.back().to, direction_at_end(one.back()), 0.5 * how.width_m};
    return free_run(end, limits, how.most_m - (length(one) - start_m));
  };
  FreeRun run = run_of(path);
  double turned = 0;
  while (meets_bend(run, how.boundary)) {
    turned += std::abs(run.side_turn);
    const std::optional<Path> along = turned < kCorner_rad ? turned_along_edge(path, run, how) : std::nullopt;
    if (!along || !std::ranges::all_of(limits, [&](const SwathLimit& limit) {
          return keeps_off(along->back(), limit, how.width_m);
        }))
      break;
    const FreeRun farther = run_of(*along);
    if (length(*along) + farther.by_m < length(path) + run.by_m + kNoRun_m) break;
    path = *along;
    run = farther;
  }
  if (run.by_m >= kNoRun_m) go_on(path, run.by_m);
  return path;
}

Path driven_to_the_end(Path path, const std::vector<SwathLimit>& limits, DrivenOn how) {
  for (int end = 0; end < 2; ++end) {
    path = reversed(driven_on(std::move(path), limits, how));
    how.boundary = reversed(how.boundary);
  }
  return path;
}

}  // namespace tramline
