#include "tramline/geometry/index/edge_index.h"

namespace tramline {

EdgeIndex::EdgeIndex(const Region& oriented) {
  std::vector<Box> boxes;
  for (const Ring& ring : rings_of(oriented))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges_.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
      boxes.push_back(bounds(edges_.back().from, edges_.back().to));
    }
  grid_ = BoxGrid(boxes);
}

bool EdgeIndex::contains(Point p) const {
  bool inside = false;
  for (const Edge& e : edges_) {
    const Point a = e.from, b = e.to;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace tramline
