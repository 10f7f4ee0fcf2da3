#include "tramline/coverage/nest_holes.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "tramline/geometry/span_index.h"

namespace tramline::coverage {
namespace {

struct RingEdge {
  GridPoint from;
  GridPoint to;
  std::size_t ring = 0;
};

void append_edges(const GridRing& ring, std::size_t number, std::vector<RingEdge>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (const GridPoint to = ring[i + 1 < ring.size() ? i + 1 : 0]; to.y != ring[i].y)
      out.push_back({ring[i], to, number});
}

/// Where the edge lies at that height; infinite where it does not reach it.
double place_at(const RingEdge& edge, double y) {
  const auto from = static_cast<double>(edge.from.y), to = static_cast<double>(edge.to.y);
  if ((from > y) == (to > y)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(edge.from.x) +
         (y - from) / (to - from) * static_cast<double>(edge.to.x - edge.from.x);
}

/// A height at which a ring has edges and no corner, mostly.
double height_through(const GridRing& ring) {
  constexpr double kOdd = 0.38196601;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (a.y != b.y) return static_cast<double>(a.y) + kOdd * static_cast<double>(b.y - a.y);
  }
  return static_cast<double>(ring.front().y);
}

}  // namespace

Int128 twice_area(const GridRing& ring) {
  Int128 out = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) out += turn(ring[0], ring[i - 1], ring[i]);
  return out;
}

// West of the westernmost edge of a hole, at any height, lies the ground that it is a hole of. The first
// edge that one meets there belongs to the same ground: its outer ring, or another hole further west.
std::vector<std::size_t> parents_of(const std::vector<GridRing>& holes, const std::vector<GridRing>& outer) {
  std::vector<std::size_t> parents(holes.size(), outer.size());
  if (holes.empty()) return parents;
  std::vector<RingEdge> edges;
  for (std::size_t i = 0; i < outer.size(); ++i) append_edges(outer[i], i, edges);
  for (std::size_t i = 0; i < holes.size(); ++i) append_edges(holes[i], outer.size() + i, edges);
  std::vector<Interval> spans;
  spans.reserve(edges.size());
  for (const RingEdge& e : edges)
    spans.push_back(
        {static_cast<double>(std::min(e.from.y, e.to.y)), static_cast<double>(std::max(e.from.y, e.to.y))});
  const SpanIndex rows(spans);

  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> west(holes.size(), kNone);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const double y = height_through(holes[i]);
    const std::size_t self = outer.size() + i;
    double own = std::numeric_limits<double>::infinity();
    for (const std::uint32_t e : rows.near(y))
      if (edges[e].ring == self) own = std::min(own, place_at(edges[e], y));
    double nearest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t e : rows.near(y)) {
      const double x = place_at(edges[e], y);
      if (edges[e].ring == self || !(x <= own) || x < nearest) continue;
      nearest = x;
      west[i] = edges[e].ring;
    }
  }
  for (std::size_t i = 0; i < holes.size(); ++i) {
    std::size_t ring = west[i];
    for (std::size_t n = 0; n < holes.size() && ring != kNone && ring >= outer.size(); ++n)
      ring = west[ring - outer.size()];
    west[i] = ring;  // a hole further east that leads here has it at once
    if (ring < outer.size()) parents[i] = ring;
  }
  return parents;
}

}  // namespace tramline::coverage
