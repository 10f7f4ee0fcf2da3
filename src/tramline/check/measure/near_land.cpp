#include "tramline/check/measure/near_land.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

struct RingEdge {
  Point from;
  Point to;
  Point left;  ///< unit vector across
};

/// The edges of a ring that have a direction.
std::vector<RingEdge> edges_of(const Ring& ring) {
  std::vector<RingEdge> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double length_m = distance(from, to);
    if (length_m <= kShortest_m) continue;
    out.push_back({from, to, {(from.y - to.y) / length_m, (to.x - from.x) / length_m}});
  }
  return out;
}

/// By how much the ring turns to the right between two edges, rad; 0 where it turns to the left: what is
/// left of it there is near to the edges.
double turn_out(const RingEdge& before, const RingEdge& behind) {
  return std::max(0.0, -std::atan2(cross(before.left, behind.left), dot(before.left, behind.left)));
}

Ring strip(const RingEdge& edge, double width_m) {
  return {edge.from, edge.to, edge.to + width_m * edge.left, edge.from + width_m * edge.left};
}

/// Between the strips of two edges, about the corner where the second begins.
Ring fan(const RingEdge& before, const RingEdge& behind, double radius_m) {
  const double turn = turn_out(before, behind);
  const double step = 2 * std::acos(std::max(0.0, 1 - kFanSagitta_m / radius_m));
  const int chords = std::max(1, static_cast<int>(std::ceil(turn / step)));
  Ring out{behind.from};
  for (int i = 0; i <= chords; ++i) {
    const double angle = -turn * i / chords;
    const Point n = before.left;
    out.push_back(behind.from + radius_m * Point{n.x * std::cos(angle) - n.y * std::sin(angle),
                                                 n.x * std::sin(angle) + n.y * std::cos(angle)});
  }
  return out;
}

}  // namespace

Region land_near(const Ring& ring, double distance_m) {
  // A fan of less is a needle that rounding may turn over.
  constexpr double kLeastTurn = 1e-7;
  const std::vector<RingEdge> edges = edges_of(ring);
  Region parts;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RingEdge& behind = edges[i + 1 < edges.size() ? i + 1 : 0];
    parts.push_back({strip(edges[i], distance_m), {}});
    if (turn_out(edges[i], behind) > kLeastTurn) parts.push_back({fan(edges[i], behind, distance_m), {}});
  }
  return unite(parts);
}

double arcs_about_corners_m(const Ring& ring, double distance_m) {
  const std::vector<RingEdge> edges = edges_of(ring);
  double sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    sum += distance_m * turn_out(edges[i], edges[i + 1 < edges.size() ? i + 1 : 0]);
  return sum;
}

}  // namespace tramline::check
