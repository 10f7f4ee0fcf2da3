#include "tramline/decomposition/cuts.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

#include "tramline/decomposition/tolerances.h"
#include "tramline/decomposition/turned_boundary.h"
#include "tramline/geometry/polygon/faces.h"

namespace tramline {
namespace {

/// Whether a ray from the corner in direction `ray` starts into the field: strictly between the two
/// edges, on the left of the ring. Rays within kAlongEdge_rad of an edge follow that edge; it exceeds
/// kSameDirectionRadians, by which the sweep may differ from the edge it comes from.
bool points_inside(const SplitEvent& corner, Point ray) {
  const Point to_next = corner.next - corner.vertex, to_previous = corner.previous - corner.vertex;
  const auto turn_from_next = [&to_next](Point v) {
    const double angle = std::atan2(cross(to_next, v), dot(to_next, v));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  const double opening = turn_from_next(to_previous);
  const double turn = turn_from_next(ray);
  return turn > kAlongEdge_rad && turn < opening - kAlongEdge_rad;
}

/// Whether the ray starts into the field at every corner that shares the event's point: where a hole
/// touches another ring, the field lies between both.
bool starts_inside(const std::vector<SplitEvent>& corners_here, Point ray) {
  return std::all_of(corners_here.begin(), corners_here.end(),
                     [ray](const SplitEvent& corner) { return points_inside(corner, ray); });
}

Cut cut_to(const Hit& hit, const Polygon& polygon, Point from, Point ray) {
  const Ring& ring = hit.ring == 0 ? polygon.outer : polygon.holes[hit.ring - 1];
  if (hit.vertex) return {from, ring[hit.index], -1, 0};
  return {from, from + hit.reach * ray, static_cast<int>(hit.ring), hit.index};
}

/// Points to be inserted between the ends of an edge, by ring and edge.
using Insertions = std::map<std::pair<int, std::size_t>, std::vector<Point>>;

/// Ends of cuts that nearly coincide on one edge become one point.
Insertions insertions_of(std::vector<Cut>& cuts) {
  Insertions out;
  for (Cut& cut : cuts) {
    if (cut.ring < 0) continue;
    auto& points = out[{cut.ring, cut.edge}];
    const auto same = std::find_if(points.begin(), points.end(),
                                   [&cut](Point p) { return distance(p, cut.to) <= kSameLine; });
    if (same != points.end())
      cut.to = *same;
    else
      points.push_back(cut.to);
  }
  return out;
}

Ring with_insertions(const Ring& ring, int number, const Insertions& insertions) {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    out.push_back(ring[i]);
    const auto found = insertions.find({number, i});
    if (found == insertions.end()) continue;
    std::vector<Point> points = found->second;
    std::sort(points.begin(), points.end(),
              [&](Point a, Point b) { return distance(ring[i], a) < distance(ring[i], b); });
    out.insert(out.end(), points.begin(), points.end());
  }
  return out;
}

/// Both directions of every cut, each cut once even where two events face one another.
std::vector<DirectedEdge> cut_edges(const std::vector<Cut>& cuts) {
  const auto key = [](const DirectedEdge& e) { return std::tie(e.from.x, e.from.y, e.to.x, e.to.y); };
  std::vector<DirectedEdge> out;
  for (const Cut& cut : cuts) {
    out.push_back({cut.from, cut.to});
    out.push_back({cut.to, cut.from});
  }
  std::sort(out.begin(), out.end(), [key](const auto& a, const auto& b) { return key(a) < key(b); });
  out.erase(
      std::unique(out.begin(), out.end(), [key](const auto& a, const auto& b) { return key(a) == key(b); }),
      out.end());
  return out;
}

}  // namespace

std::vector<Cut> cuts_at(const Polygon& polygon, const std::vector<SplitEvent>& events, Direction direction) {
  const TrackFrame frame(direction);
  const TurnedBoundary boundary(polygon, frame);
  std::vector<Cut> cuts;
  for (const SplitEvent& event : events) {
    const std::vector<SplitEvent> corners = boundary.corners_at(event.vertex);
    const Point start = frame.to_track(event.vertex);
    for (const int sense : {+1, -1}) {
      const Point ray = static_cast<double>(sense) * direction.unit();
      if (!starts_inside(corners, ray)) continue;
      const Hit hit = boundary.nearest(start, sense);
      if (!std::isfinite(hit.reach)) continue;
      const Cut cut = cut_to(hit, polygon, event.vertex, ray);
      const bool follows_edge = cut.to == event.previous || cut.to == event.next;
      // Edges of a micrometre can hide from the ray what is in its way: no cut is better than one outside.
      if (!follows_edge && boundary.inside({start.x, start.y + 0.5 * sense * hit.reach})) cuts.push_back(cut);
    }
  }
  return cuts;
}

Region divided(const Polygon& polygon, const std::vector<Cut>& cuts) {
  std::vector<Cut> placed = cuts;
  const Insertions insertions = insertions_of(placed);
  Polygon noded{with_insertions(polygon.outer, 0, insertions), {}};
  for (std::size_t h = 0; h < polygon.holes.size(); ++h)
    noded.holes.push_back(with_insertions(polygon.holes[h], static_cast<int>(h) + 1, insertions));
  std::vector<DirectedEdge> edges = edges_of(noded);
  for (const DirectedEdge& edge : cut_edges(placed)) edges.push_back(edge);
  return faces_of(std::move(edges));
}

}  // namespace tramline
