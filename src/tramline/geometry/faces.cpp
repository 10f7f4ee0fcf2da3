#include "tramline/geometry/faces.h"

#include <algorithm>
#include <numbers>
#include <tuple>

namespace tramline {
namespace {

bool before(Point a, Point b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

bool edge_before(const DirectedEdge& a, const DirectedEdge& b) {
  return std::tie(a.from.x, a.from.y, a.to.x, a.to.y) < std::tie(b.from.x, b.from.y, b.to.x, b.to.y);
}

/// Angle from `back` clockwise to `out`, in (0, 2π]: going straight back comes last.
double clockwise_turn(Point back, Point out) {
  const double angle = std::atan2(cross(out, back), dot(out, back));
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// Walks along sorted edges.
class Walk {
 public:
  explicit Walk(std::vector<DirectedEdge> edges) : edges_(std::move(edges)), used_(edges_.size(), false) {
    std::sort(edges_.begin(), edges_.end(), edge_before);
  }

  /// All closed walks, each as its points.
  std::vector<Ring> cycles() {
    std::vector<Ring> out;
    for (std::size_t first = 0; first < edges_.size(); ++first) {
      if (used_[first]) continue;
      Ring cycle;
      for (std::size_t e = first; e < edges_.size() && !used_[e]; e = next_after(e)) {
        used_[e] = true;
        cycle.push_back(edges_[e].from);
      }
      out.push_back(std::move(cycle));
    }
    return out;
  }

 private:
  std::size_t next_after(std::size_t e) const {
    const Point node = edges_[e].to;
    const auto first =
        std::lower_bound(edges_.begin(), edges_.end(), node,
                         [](const DirectedEdge& edge, Point p) { return before(edge.from, p); });
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

/// Takes a closed walk apart where it passes a point twice.
void append_simple_rings(const Ring& cycle, std::vector<Ring>& out) {
  std::vector<Point> sorted = cycle;
  std::sort(sorted.begin(), sorted.end(), before);
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) {
    out.push_back(cycle);
    return;
  }
  Ring path;
  for (const Point p : cycle) {
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

void place_hole(Ring hole, Region& region) {
  Polygon* smallest = nullptr;
  double smallest_area = 0;
  const Box box = bounds(hole);
  for (Polygon& polygon : region) {
    if (!intersects(bounds(polygon.outer), box)) continue;
    const double size = signed_area(polygon.outer);
    if ((smallest != nullptr && size >= smallest_area) || !encloses(polygon.outer, hole)) continue;
    smallest = &polygon;
    smallest_area = size;
  }
  if (smallest != nullptr) smallest->holes.push_back(std::move(hole));
}

}  // namespace

std::vector<DirectedEdge> edges_of(const Polygon& polygon) {
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
  for (const Ring& cycle : Walk(std::move(edges)).cycles()) append_simple_rings(cycle, rings);
  Region region;
  std::vector<Ring> holes;
  for (Ring& ring : rings) {
    const double size = signed_area(ring);
    if (size > 0) region.push_back({std::move(ring), {}});
    if (size < 0) holes.push_back(std::move(ring));
  }
  for (Ring& hole : holes) place_hole(std::move(hole), region);
  return region;
}

Region dissolved(const Region& cells) {
  std::vector<DirectedEdge> edges;
  for (const Polygon& cell : cells) {
    const auto more = edges_of(cell);
    edges.insert(edges.end(), more.begin(), more.end());
  }
  std::sort(edges.begin(), edges.end(), edge_before);
  std::vector<DirectedEdge> left;
  for (const DirectedEdge& edge : edges)
    if (!std::binary_search(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from}, edge_before))
      left.push_back(edge);
  return faces_of(std::move(left));
}

}  // namespace tramline
