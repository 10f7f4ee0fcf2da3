#include "tramline/admission/ring_crossings.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tramline {
namespace {

struct RingEdge {
  Point from, to;
  Box box;
};

bool on_either_side(const RingEdge& line, const RingEdge& of) {
  const double a = cross(line.to - line.from, of.from - line.from);
  const double b = cross(line.to - line.from, of.to - line.from);
  return (a > 0 && b < 0) || (a < 0 && b > 0);
}

std::vector<RingEdge> edges_from_the_left(const Ring& ring) {
  std::vector<RingEdge> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    out.push_back({from, to, bounds(from, to)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const RingEdge& a, const RingEdge& b) { return a.box.min_x < b.box.min_x; });
  return out;
}

}  // namespace

std::size_t ring_crossings(const Ring& ring, std::size_t most) {
  const std::vector<RingEdge> edges = edges_from_the_left(ring);
  std::vector<std::uint32_t> open;  // edges that reach as far right as the one looked at
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    std::erase_if(open, [&](std::uint32_t k) { return edges[k].box.max_x < edges[i].box.min_x; });
    for (const std::uint32_t k : open)
      if (intersects(edges[k].box, edges[i].box) && on_either_side(edges[k], edges[i]) &&
          on_either_side(edges[i], edges[k]) && ++count > most)
        return count;
    open.push_back(i);
  }
  return count;
}

}  // namespace tramline
