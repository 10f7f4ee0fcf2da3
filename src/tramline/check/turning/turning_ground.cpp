#include "tramline/check/turning/turning_ground.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace tramline::check {
namespace {

bool inside(const Ring& ring, Point p) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

double distance_to(const Ring& ring, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

/// Where a side crosses an edge, as a share of the side.
std::optional<double> crossing(const Side& side, Point a, Point b) {
  const Point along = side[1] - side[0], edge = b - a;
  const double turn = cross(along, edge);
  if (turn == 0) return std::nullopt;
  const double at = cross(a - side[0], edge) / turn, on_edge = cross(a - side[0], along) / turn;
  if (at < 0 || at > 1 || on_edge < 0 || on_edge > 1) return std::nullopt;
  return at;
}

}  // namespace

TurningGround::TurningGround(const Plan& plan) {
  const PlanSettings& settings = plan.settings;
  const bool inside = settings.headland_rule == HeadlandRule::kTurns && settings.turn_room_m < 0;
  const bool hard = settings.boundary == EdgeKind::kHard || settings.headlands > 0 || inside;
  if (hard || settings.turn_room_m >= 0) {
    rings_.push_back({plan.field.outer, bounds(plan.field.outer), true});
    if (!hard) beyond_m_ = settings.turn_room_m;
  }
  for (const Obstacle& obstacle : plan.field.obstacles)
    rings_.push_back({obstacle.shape.outer, bounds(obstacle.shape.outer), false});
}

void TurningGround::measure(const BoundedRing& ring, const std::vector<Side>& near_edges, const Side& side,
                            Excursion& deepest) const {
  std::vector<double> at{0, 1};
  for (const Side& edge : near_edges)
    if (const auto share = crossing(side, edge[0], edge[1])) at.push_back(*share);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double half_way = 0.5 * (at[i] + at[i + 1]);
    if (inside(ring.ring, side[0] + half_way * (side[1] - side[0])) == ring.field) continue;
    for (const double share : {at[i], half_way, at[i + 1]}) {
      const Point p = side[0] + share * (side[1] - side[0]);
      const double depth_m = distance_to(ring.ring, p) - (ring.field ? beyond_m_ : 0);
      if (depth_m > deepest.depth_m) deepest = {depth_m, p};
    }
  }
}

void TurningGround::measure(const BoundedRing& ring, const std::vector<Outline>& outlines, const Box& reach,
                            Excursion& deepest) const {
  if (!ring.field && !intersects(reach, ring.box)) return;
  std::vector<Side> near_edges;
  for (std::size_t i = 0; i < ring.ring.size(); ++i) {
    const Side edge{ring.ring[i], ring.ring[(i + 1) % ring.ring.size()]};
    Box box;
    box.extend(edge[0]);
    box.extend(edge[1]);
    if (intersects(box, reach)) near_edges.push_back(edge);
  }
  // Where no edge is near, all of the outline is on the same side of the ring.
  if (near_edges.empty() && inside(ring.ring, outlines.front().front()[0]) == ring.field) return;
  for (const Outline& outline : outlines)
    for (const Side& side : outline) measure(ring, near_edges, side, deepest);
}

Excursion TurningGround::deepest(const SteeredPath& path, const Machine& machine, double step_m) const {
  std::vector<Outline> outlines;
  Box reach;
  for (const MachinePlace& place : places_along(path, machine, step_m)) {
    outlines.push_back(outline_at(place, machine));
    for (const Side& side : outlines.back())
      for (const Point corner : side) reach.extend(corner);
  }
  Excursion out;
  if (outlines.empty() || outlines.front().empty()) return out;
  for (const BoundedRing& ring : rings_) measure(ring, outlines, reach, out);
  return out;
}

}  // namespace tramline::check
