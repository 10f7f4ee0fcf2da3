#include "tramline/decomposition/turned_boundary.h"

#include <algorithm>
#include <cmath>

#include "tramline/decomposition/cuts.h"
#include "tramline/decomposition/tolerances.h"

namespace tramline {
namespace {

std::vector<const Ring*> rings_in_order(const Polygon& polygon) {
  std::vector<const Ring*> rings{&polygon.outer};
  for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  return rings;
}

std::size_t index_after(std::size_t index, const Ring& ring) {
  return index + 1 == ring.size() ? 0 : index + 1;
}
std::size_t index_before(std::size_t index, const Ring& ring) {
  return index == 0 ? ring.size() - 1 : index - 1;
}

}  // namespace

TurnedBoundary::TurnedBoundary(const Polygon& polygon, const TrackFrame& frame)
    : frame_(frame),
      rings_(rings_in_order(polygon)),
      edges_(edges_of(rings_, frame)),
      across_(by_coordinate(edges_, &Point::x)),
      along_(by_coordinate(edges_, &Point::y)) {}

std::vector<TurnedBoundary::Edge> TurnedBoundary::edges_of(const std::vector<const Ring*>& rings,
                                                           const TrackFrame& frame) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring turned = frame.to_track(*rings[r]);
    for (std::size_t i = 0; i < turned.size(); ++i)
      edges.push_back({turned[i], turned[index_after(i, turned)], static_cast<std::uint32_t>(r),
                       static_cast<std::uint32_t>(i)});
  }
  return edges;
}

SpanIndex TurnedBoundary::by_coordinate(const std::vector<Edge>& edges, double Point::*coordinate) {
  // A vertex is on a ray that passes it within kSameLine.
  constexpr double kMargin = 2 * kSameLine;
  std::vector<Interval> spans;
  spans.reserve(edges.size());
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax(edge.from.*coordinate, edge.to.*coordinate);
    spans.push_back({low - kMargin, high + kMargin});
  }
  return SpanIndex(spans);
}

Hit TurnedBoundary::nearest(Point start, int sense) const {
  Hit hit;
  const auto offer = [&](double y, const Edge& edge, bool vertex) {
    const double reach = sense * (y - start.y);
    if (reach > kSameLine && reach < hit.reach) hit = {reach, edge.ring, edge.index, vertex};
  };
  for (const std::uint32_t number : across_.near(start.x)) {
    const Edge& edge = edges_[number];
    const Point a = edge.from, b = edge.to;
    const double to_a = a.x - start.x, to_b = b.x - start.x;
    if (std::abs(to_a) <= kSameLine)
      offer(a.y, edge, true);
    else if (std::abs(to_b) > kSameLine && (to_a < 0) != (to_b < 0))
      offer(a.y + (b.y - a.y) * (to_a / (to_a - to_b)), edge, false);
  }
  return hit;
}

std::vector<SplitEvent> TurnedBoundary::corners_at(Point vertex) const {
  std::vector<SplitEvent> out;
  for (const std::uint32_t number : across_.near(frame_.to_track(vertex).x)) {
    const Ring& ring = *rings_[edges_[number].ring];
    const std::size_t i = edges_[number].index;
    if (ring[i] == vertex) out.push_back({ring[index_before(i, ring)], vertex, ring[index_after(i, ring)]});
  }
  return out;
}

bool TurnedBoundary::inside(Point p) const {
  bool odd = false;
  for (const std::uint32_t number : along_.near(p.y)) {
    const Point a = edges_[number].to, b = edges_[number].from;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) odd = !odd;
  }
  return odd;
}

}  // namespace tramline
