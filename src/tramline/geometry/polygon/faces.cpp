#include "tramline/geometry/polygon/faces.h"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <tuple>

namespace tramline {
namespace {

struct PointBefore {
  bool operator()(Point a, Point b) const { return a.x < b.x || (a.x == b.x && a.y < b.y); }
};

struct EdgeBefore {
  bool operator()(const DirectedEdge& a, const DirectedEdge& b) const {
    if (a.from.x != b.from.x) return a.from.x < b.from.x;
    return std::tie(a.from.y, a.to.x, a.to.y) < std::tie(b.from.y, b.to.x, b.to.y);
  }
};

/// Angle from `back` clockwise to `out`, in (0, 2π]: going straight back comes last.
double clockwise_turn(Point back, Point out) {
  const double angle = std::atan2(cross(out, back), dot(out, back));
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// A closed walk along edges.
struct Cycle {
  Ring points;
  Ring forks;  ///< the points from which more than one edge sets out
};

/// Walks along sorted edges.
class Walk {
 public:
  explicit Walk(std::vector<DirectedEdge> edges) : edges_(std::move(edges)), used_(edges_.size(), false) {
    if (!std::is_sorted(edges_.begin(), edges_.end(), EdgeBefore{}))
      std::sort(edges_.begin(), edges_.end(), EdgeBefore{});
  }

  std::vector<Cycle> cycles() {
    std::vector<Cycle> out;
    for (std::size_t first = 0; first < edges_.size(); ++first) {
      if (used_[first]) continue;
      Cycle cycle;
      for (std::size_t e = first; e < edges_.size() && !used_[e]; e = next_after(e)) {
        used_[e] = true;
        cycle.points.push_back(edges_[e].from);
        if (is_fork(e)) cycle.forks.push_back(edges_[e].from);
      }
      out.push_back(std::move(cycle));
    }
    return out;
  }

 private:
  bool is_fork(std::size_t e) const {
    const auto sets_out_beside = [&](std::size_t other) { return edges_[other].from == edges_[e].from; };
    return (e > 0 && sets_out_beside(e - 1)) || (e + 1 < edges_.size() && sets_out_beside(e + 1));
  }

  std::size_t next_after(std::size_t e) const {
    const Point node = edges_[e].to;
    const auto first =
        std::lower_bound(edges_.begin(), edges_.end(), node,
                         [](const DirectedEdge& edge, Point p) { return PointBefore{}(edge.from, p); });
    const Point back = edges_[e].from - node;
    std::size_t best = edges_.size();
    double least = 0;
    for (auto edge = first; edge != edges_.end() && edge->from == node; ++edge) {
      const auto index = static_cast<std::size_t>(edge - edges_.begin());
      const bool alone = edge == first && (edge + 1 == edges_.end() || !((edge + 1)->from == node));
      if (alone) return index;
      const double turn = clockwise_turn(back, edge->to - node);
      if (best == edges_.size() || turn < least) {
        best = index;
        least = turn;
      }
    }
    return best;
  }

  std::vector<DirectedEdge> edges_;
  std::vector<bool> used_;
};

/// Splits a closed walk where it passes a point twice: only at forks, since no edge is walked twice.
void append_simple_rings(Cycle cycle, std::vector<Ring>& out) {
  std::sort(cycle.forks.begin(), cycle.forks.end(), PointBefore{});
  if (std::adjacent_find(cycle.forks.begin(), cycle.forks.end()) == cycle.forks.end()) {
    out.push_back(std::move(cycle.points));
    return;
  }
  Ring path;
  for (const Point p : cycle.points) {
    const auto again = std::find(path.begin(), path.end(), p);
    if (again != path.end()) {
      out.emplace_back(again, path.end());
      path.erase(again, path.end());
    }
    path.push_back(p);
  }
  out.push_back(std::move(path));
}

/// Whether the outer ring encloses the hole, judged at a vertex of the hole that is not the ring's own.
bool encloses(const Ring& outer, const Ring& hole) {
  for (const Point p : hole)
    if (std::find(outer.begin(), outer.end(), p) == outer.end()) return contains(outer, p);
  return false;
}

void place_holes(std::vector<Ring> holes, Region& region) {
  if (holes.empty()) return;
  std::vector<Box> boxes;
  for (const Polygon& polygon : region) boxes.push_back(bounds(polygon.outer));
  for (Ring& hole : holes) {
    Polygon* smallest = nullptr;
    double smallest_area = 0;
    const Box box = bounds(hole);
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (!intersects(boxes[i], box)) continue;
      const double size = signed_area(region[i].outer);
      if ((smallest != nullptr && size >= smallest_area) || !encloses(region[i].outer, hole)) continue;
      smallest = &region[i];
      smallest_area = size;
    }
    if (smallest != nullptr) smallest->holes.push_back(std::move(hole));
  }
}

/// An edge whichever way it is walked.
struct Undirected {
  DirectedEdge ends;    ///< from the lesser end
  bool turned = false;  ///< the polygon walks it the other way
};

}  // namespace

std::vector<DirectedEdge> edges_of(const Polygon& polygon) {
  assert(signed_area(polygon.outer) >= 0);
  assert(std::all_of(polygon.holes.begin(), polygon.holes.end(),
                     [](const Ring& hole) { return signed_area(hole) <= 0; }));
  std::vector<DirectedEdge> out;
  const auto append = [&out](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) out.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  append(polygon.outer);
  for (const Ring& hole : polygon.holes) append(hole);
  return out;
}

Region faces_of(std::vector<DirectedEdge> edges) {
  std::vector<Ring> rings;
  for (Cycle& cycle : Walk(std::move(edges)).cycles()) append_simple_rings(std::move(cycle), rings);
  Region region;
  std::vector<Ring> holes;
  for (Ring& ring : rings) {
    const double size = signed_area(ring);
    if (size > 0)
      region.push_back({std::move(ring), {}});
    else if (size < 0)
      holes.push_back(std::move(ring));
  }
  place_holes(std::move(holes), region);
  return region;
}

Region dissolved(const Region& cells) {
  std::vector<Undirected> edges;
  for (const Polygon& cell : cells)
    for (const DirectedEdge& edge : edges_of(cell)) {
      if (edge.from == edge.to) continue;
      const bool turned = PointBefore{}(edge.to, edge.from);
      edges.push_back({turned ? DirectedEdge{edge.to, edge.from} : edge, turned});
    }
  std::sort(edges.begin(), edges.end(),
            [](const Undirected& a, const Undirected& b) { return EdgeBefore{}(a.ends, b.ends); });
  std::vector<DirectedEdge> left;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(
        edge, edges.end(), [&](const Undirected& other) { return EdgeBefore{}(edge->ends, other.ends); });
    const bool cancels =
        std::any_of(edge, next, [&](const Undirected& other) { return other.turned != edge->turned; });
    for (; edge != next; ++edge)
      if (!cancels) left.push_back(edge->turned ? DirectedEdge{edge->ends.to, edge->ends.from} : edge->ends);
  }
  return faces_of(std::move(left));
}

}  // namespace tramline
