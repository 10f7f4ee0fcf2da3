#include "tramline/check/turning/turning_ground.h"

#include <algorithm>
#include <cmath>
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

/// So many places are compared with the edges near them together.
constexpr std::size_t kTogether = 200;
/// Long lines and arcs are looked at in sections of this length, m.
constexpr double kSection_m = 10;

std::vector<SteeredStretch> sections_of(const SteeredStretch& stretch) {
  if (stretch.clothoid() || stretch.length_m <= kSection_m) return {stretch};
  const double count = std::ceil(stretch.length_m / kSection_m);
  std::vector<SteeredStretch> out;
  for (double i = 0; i < count; ++i) {
    SteeredStretch section = stretch;
    section.start = pose_after(stretch, i / count * stretch.length_m);
    section.length_m = stretch.length_m / count;
    out.push_back(section);
  }
  return out;
}

/// No point of the outline is farther from the axle.
double reach_m(const Machine& machine) {
  const Turning& turning = machine.turning;
  return std::abs(turning.implement_offset_m) + turning.drawbar_m + turning.rear_overhang_m +
         turning.front_overhang_m + machine.width_m + turning.vehicle_width_m;
}

}  // namespace

std::optional<double> land_beyond_m(const Plan& plan) {
  const PlanSettings& settings = plan.settings;
  const bool inside = settings.headland_rule == HeadlandRule::kTurns && settings.turn_room_m < 0;
  if (settings.boundary == EdgeKind::kHard || settings.headlands > 0 || inside) return 0;
  if (settings.turn_room_m >= 0) return settings.turn_room_m;
  return std::nullopt;
}

TurningGround::TurningGround(const Plan& plan, Passables passables, Beyond beyond) {
  const std::optional<double> beyond_m = land_beyond_m(plan);
  if (beyond == Beyond::kAsForTurns && beyond_m) {
    rings_.push_back({plan.field.outer, bounds(plan.field.outer), true});
    beyond_m_ = *beyond_m;
  }
  for (const Obstacle& obstacle : plan.field.obstacles)
    if (obstacle.kind != ObstacleKind::kPassable || passables == Passables::kAreObstacles)
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

/// Whether no edge is near enough for the outline, which reaches `outline_m` from the axle, to touch it.
bool TurningGround::clear_of_edges(const SteeredStretch& stretch, double outline_m) const {
  const double bent =
      std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end)) * stretch.length_m;
  // An arc of angle `bent` and this length is no farther from its chord.
  const double aside_m = std::min(1.0, bent) * stretch.length_m;
  const Box reach = bounds(stretch.start.at, end_of(stretch).at).grown(aside_m + outline_m);
  return std::all_of(rings_.begin(), rings_.end(), [&](const BoundedRing& ring) {
    if (!intersects(reach, ring.box)) return !ring.field;
    for (std::size_t i = 0; i < ring.ring.size(); ++i)
      if (intersects(bounds(ring.ring[i], ring.ring[(i + 1) % ring.ring.size()]), reach)) return false;
    return inside(ring.ring, stretch.start.at) == ring.field;
  });
}

void TurningGround::measure(const std::vector<MachinePlace>& places, const Machine& machine,
                            Excursion& deepest) const {
  for (std::size_t from = 0; from < places.size(); from += kTogether) {
    std::vector<Outline> outlines;
    Box reach;
    for (std::size_t i = from; i < std::min(places.size(), from + kTogether); ++i) {
      outlines.push_back(outline_at(places[i], machine));
      for (const Side& side : outlines.back())
        for (const Point corner : side) reach.extend(corner);
    }
    if (outlines.front().empty()) return;
    for (const BoundedRing& ring : rings_) measure(ring, outlines, reach, deepest);
  }
}

Excursion TurningGround::deepest(const SteeredPath& path, const Machine& machine, double step_m) const {
  Excursion out;
  if (rings_.empty() || path.empty()) return out;
  const double outline_m = reach_m(machine);
  const bool swings = tows(machine.turning);
  const bool straight = std::all_of(path.begin(), path.end(), [](const SteeredStretch& stretch) {
    return stretch.curvature_at_start == 0 && stretch.curvature_at_end == 0;
  });
  if (swings && !straight) {
    // A drawbar stays within its length of the hitch, wherever it points.
    const bool clear = std::all_of(path.begin(), path.end(), [&](const SteeredStretch& stretch) {
      return clear_of_edges(stretch, outline_m);
    });
    if (!clear) measure(places_along(path, machine, step_m), machine, out);
    return out;
  }
  for (const SteeredStretch& whole : path)
    for (const SteeredStretch& stretch : sections_of(whole))
      if (!clear_of_edges(stretch, outline_m))
        measure(places_along({stretch}, machine, step_m), machine, out);
  return out;
}

}  // namespace tramline::check
