#include "tramline/planner/search/edge_aligned_grids.h"

#include <algorithm>

#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/tolerances.h"

namespace tramline {
namespace {

/// Edges of one direction.
struct Edges {
  double angle = 0, length = 0, longest = 0;
  Point at;  ///< on the longest
};

/// By their angles, each by itself.
std::vector<Edges> edges_by_ring(const Polygon& part) {
  std::vector<Edges> out;
  for (const Ring& ring : rings_of({part}))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a == b) continue;
      const double length = distance(a, b);
      out.push_back({Direction::along(a, b).angle().radians(), length, length, a});
    }
  std::sort(out.begin(), out.end(), [](const Edges& a, const Edges& b) { return a.angle < b.angle; });
  return out;
}

std::vector<Edges> by_direction(const std::vector<Edges>& edges) {
  std::vector<Edges> out;
  for (const Edges& edge : edges) {
    if (out.empty() || edge.angle - out.back().angle > kSameDirectionRadians) {
      out.push_back(edge);
      continue;
    }
    Edges& group = out.back();
    group.length += edge.length;
    if (edge.longest > group.longest) {
      group.longest = edge.longest;
      group.at = edge.at;
    }
  }
  return out;
}

}  // namespace

std::vector<GridPosition> edge_aligned_grids(const Polygon& part, Point pivot, std::size_t most) {
  std::vector<Edges> groups = by_direction(edges_by_ring(part));
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Edges& a, const Edges& b) { return a.length > b.length; });
  if (groups.size() > most) groups.resize(most);
  std::vector<GridPosition> out;
  for (const Edges& group : groups) {
    const TrackFrame frame = GridPricing::frame(group.angle);
    out.push_back({group.angle, frame.to_track(group.at).x - frame.to_track(pivot).x});
  }
  return out;
}

}  // namespace tramline
