#include "tramline/check/prices/detour_reach.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// More than the cotangent of the steepest angle at which a detour leaves its track, 75 degrees.
constexpr double kSteepestFoot = 0.27;
/// A detour that never leaves the steepest angle is so many times as long as its rows, at most.
constexpr double kSteepestLength = 4;
/// What is rounder than its corners reaches so much of its size beyond them.
constexpr double kBeyondCorners = 0.02;

double arc_m(const Plan& plan) { return std::max(plan.machine.radius_m, 0.5 * plan.machine.width_m); }

/// How far a detour may be from its track.
double displaced_m(const Plan& plan, double across_m) {
  return (1 + 0.5 * kBeyondCorners) * across_m + plan.machine.width_m;
}

double along_m(const Plan& plan, double across_m) {
  return plan.machine.width_m + 2 * arc_m(plan) + kSteepestFoot * displaced_m(plan, across_m);
}

/// There and back, by arcs that are as tight as they may be: where a detour has turned by φ it is longer than
/// its rows by tan ½φ for every metre that it rises, and φ is largest in the middle of the rise.
double longer_m(const Plan& plan, double across_m) {
  const double rise_m = displaced_m(plan, across_m), arcs_m = 2 * arc_m(plan);
  if (plan.settings.avoid == Avoidance::kPaper || rise_m >= arcs_m) return 2 * rise_m;
  return 2 * rise_m * std::sqrt(rise_m / (2 * arcs_m - rise_m));
}

int ways_round(const Ring& ring) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
    (cross(b - a, c - b) < 0 ? right : left) += 1;
  }
  return 1 + (signed_area(ring) < 0 ? left : right);
}

double apart_m(const Box& a, const Box& b) {
  const double x = std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x});
  const double y = std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y});
  return std::hypot(x, y);
}

/// Whether the land may end between two groups.
bool ends_between(const ObstacleGroup& a, const ObstacleGroup& b, double reach_m, const Region& land) {
  Box both = a.box;
  both.extend(b.box);
  both = both.grown(reach_m);
  for (const Polygon& polygon : land)
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
      if (intersects(bounds(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()]), both))
        return true;
  return false;
}

}  // namespace

std::vector<ObstacleGroup> obstacle_groups(const Plan& plan, const Region& land) {
  Region hard = plan.given_up;
  for (const Obstacle& obstacle : plan.field.obstacles)
    if (obstacle.kind != ObstacleKind::kPassable) hard.push_back(obstacle.shape);
  std::vector<ObstacleGroup> out;
  const auto spread_m = [&](const ObstacleGroup& group) {
    return along_m(plan, std::hypot(group.box.width(), group.box.height()));
  };
  for (const Polygon& polygon : unite(hard)) {
    ObstacleGroup one{polygon.outer, bounds(polygon.outer).grown(std::max(0.0, plan.settings.clearance_m)),
                      ways_round(polygon.outer)};
    for (bool joined = true; joined;) {
      joined = false;
      for (std::size_t i = 0; i < out.size() && !joined; ++i) {
        const double reach_m = spread_m(one) + spread_m(out[i]) + 2 * plan.machine.width_m;
        if (apart_m(one.box, out[i].box) > reach_m && !ends_between(one, out[i], plan.machine.width_m, land))
          continue;
        one.box.extend(out[i].box);
        one.corners.insert(one.corners.end(), out[i].corners.begin(), out[i].corners.end());
        one.ways_round += out[i].ways_round;
        out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
        joined = true;
      }
    }
    out.push_back(std::move(one));
  }
  return out;
}

std::vector<DetourReach> detours_along(const Plan& plan, const std::vector<ObstacleGroup>& groups,
                                       Point pivot, Point up, double stray_m) {
  const Point right{up.y, -up.x};
  std::vector<DetourReach> out;
  std::vector<Box> boxes;
  for (const ObstacleGroup& group : groups) {
    Box box;
    for (const Point corner : group.corners)
      box.extend(Point{dot(corner - pivot, right), dot(corner - pivot, up)});
    box = box.grown(stray_m + std::max(0.0, plan.settings.clearance_m));
    boxes.push_back(box);
    const double across_m = plan.machine.width_m + 2 * stray_m +
                            kBeyondCorners * std::hypot(group.box.width(), group.box.height());
    const double rows_m = along_m(plan, box.width()) + stray_m;
    DetourReach reach{box.min_x,
                      box.max_x,
                      {box.min_x - across_m, box.min_y - rows_m, box.max_x + across_m, box.max_y + rows_m},
                      0};
    reach.longer_m =
        std::min(group.ways_round * longer_m(plan, box.width()), kSteepestLength * reach.land.height());
    out.push_back(reach);
  }
  // Where the land ends between two groups on one track, a detour may go round both.
  for (DetourReach& one : out)
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (one.land.min_x > out[i].land.max_x || out[i].land.min_x > one.land.max_x) continue;
      one.land.min_y = std::min(one.land.min_y, boxes[i].min_y);
      one.land.max_y = std::max(one.land.max_y, boxes[i].max_y);
    }
  return out;
}

}  // namespace tramline::check
