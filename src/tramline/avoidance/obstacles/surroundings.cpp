#include "tramline/avoidance/obstacles/surroundings.h"

#include <algorithm>
#include <utility>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

bool apart(const Box& a, const Box& b) {
  return a.max_x < b.min_x || a.min_x > b.max_x || a.max_y < b.min_y || a.min_y > b.max_y;
}

/// Precondition: reach_m is no more than half the swath's width.
bool any_edge_nearer(const SwathLine& line, const Ring& ring, double reach_m) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const Box edge = bounds(a, b);
    if (apart(edge, line.reach)) continue;
    for (std::size_t k = 0; k < line.path.size(); ++k)
      if (!apart(edge, line.reaches[k]) && distance_to_edge(line.path[k], a, b) < reach_m) return true;
  }
  return false;
}

}  // namespace

Surroundings turned_surroundings(const ClassifiedGround& ground, const Ring& field, EdgeKind boundary,
                                 const TrackFrame& frame) {
  Surroundings out;
  for (const Hazard& hazard : ground.hazards) {
    TurnedHazard turned{frame.to_track(hazard.shape.outer), {}, hazard.round};
    turned.box = bounds(turned.outline);
    if (turned.round) turned.round->centre = frame.to_track(turned.round->centre);
    out.hazards.push_back(std::move(turned));
  }
  for (const Ring& ring : rings_of(ground.passable)) out.passable.push_back(frame.to_track(ring));
  out.field = frame.to_track(field);
  out.boundary = boundary;
  return out;
}

Refusal fault_of(const SwathLine& line, const Surroundings& around) {
  const double half = 0.5 * line.width_m - kClearanceSlack_m;
  if (any_edge_nearer(line, around.field, kTouch_m) || !contains(around.field, line.path.front().from))
    return Refusal::kLeavesField;
  if (around.boundary == EdgeKind::kHard && any_edge_nearer(line, around.field, half))
    return Refusal::kPassesHardBoundary;
  for (const Ring& ring : around.passable)
    if (any_edge_nearer(line, ring, half)) return Refusal::kEntersPassable;
  return Refusal::kNone;
}

bool runs_into(const SwathLine& line, const TurnedHazard& hazard) {
  return intersects(hazard.box, line.reach) &&
         any_edge_nearer(line, hazard.outline, 0.5 * line.width_m - kClearanceSlack_m);
}

}  // namespace tramline
