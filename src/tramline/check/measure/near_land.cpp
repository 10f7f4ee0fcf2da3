#include "tramline/check/measure/near_land.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/check/tolerances.h"
#include "tramline/geometry/path/path.h"
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

/// Where the line through `a` across the unit vector `n` meets that through `b` across `m`.
Point meeting(Point a, Point n, Point b, Point m) {
  const double d = cross(n, m), p = dot(a, n), q = dot(b, m);
  return {(p * m.y - q * n.y) / d, (q * n.x - p * m.x) / d};
}

/// Between the strips of two edges: up to where their far sides meet, or to a line across the middle of a
/// sharper turn.
Ring mitre(const RingEdge& before, const RingEdge& behind, double distance_m) {
  const Point corner = behind.from, a = before.left, b = behind.left;
  const Point first = corner + distance_m * a, last = corner + distance_m * b;
  constexpr double kSharpest = 2 * std::numbers::pi / 3;
  if (turn_out(before, behind) <= kSharpest) return {corner, last, meeting(first, a, last, b), first};
  const double half = -0.5 * turn_out(before, behind), c = std::cos(half), s = std::sin(half);
  const Point middle{a.x * c - a.y * s, a.x * s + a.y * c}, beyond = corner + distance_m * middle;
  return {corner, last, meeting(last, b, beyond, middle), meeting(first, a, beyond, middle), first};
}

/// The ring without vertices that hardly are corners.
Ring with_corners_only(Ring ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    const std::size_t n = ring.size();
    const PathSegment past{ring[(i + n - 1) % n], ring[(i + 1) % n], 0};
    const bool idle = past.from == past.to || distance_to_edge(past, ring[i], ring[i]) <= kThinnestShown_m;
    if (!idle) {
      ++i;
      continue;
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    i = i > 0 ? i - 1 : 0;
  }
  return ring;
}

/// Beside a ring, left of it.
void append_mitred_land(const Ring& ring, double distance_m, Region& out) {
  constexpr double kLeastTurn = 1e-7;
  const std::vector<RingEdge> edges = edges_of(with_corners_only(ring));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RingEdge& behind = edges[i + 1 < edges.size() ? i + 1 : 0];
    out.push_back({strip(edges[i], distance_m), {}});
    if (turn_out(edges[i], behind) > kLeastTurn) out.push_back({mitre(edges[i], behind, distance_m), {}});
  }
}

}  // namespace

namespace {

/// The strip along an edge, and the fan between it and the next one.
void append_land_near(const RingEdge& edge, const RingEdge* next, double distance_m, Region& out) {
  // A fan of less is a needle that rounding may turn over.
  constexpr double kLeastTurn = 1e-7;
  out.push_back({strip(edge, distance_m), {}});
  if (next != nullptr && turn_out(edge, *next) > kLeastTurn)
    out.push_back({fan(edge, *next, distance_m), {}});
}

/// Without what the precision grid leaves where strips meet.
Region without_needles(Region region) {
  const auto thin = [](const Ring& ring) {
    return std::abs(signed_area(ring)) <= kThinnestShown_m * perimeter(ring);
  };
  std::erase_if(region, [&thin](const Polygon& part) { return thin(part.outer); });
  for (Polygon& part : region) std::erase_if(part.holes, thin);
  return region;
}

}  // namespace

Region moved_inwards(const Region& region, double distance_m) {
  Region passed;
  for (const Ring& ring : rings_of(region)) append_mitred_land(ring, distance_m, passed);
  return without_needles(difference(region, unite(passed)));
}

Region moved_outwards(const Region& region, double distance_m) {
  Region all = region;
  for (const Ring& ring : rings_of(region)) append_mitred_land(reversed(ring), distance_m, all);
  return without_needles(unite(all));
}

Region land_near(const Ring& ring, double distance_m) {
  const std::vector<RingEdge> edges = edges_of(ring);
  Region parts;
  for (std::size_t i = 0; i < edges.size(); ++i)
    append_land_near(edges[i], &edges[i + 1 < edges.size() ? i + 1 : 0], distance_m, parts);
  return unite(parts);
}

Region land_near_line(const std::vector<Point>& line, double distance_m) {
  std::vector<RingEdge> edges = edges_of(line);
  edges.pop_back();  // that from the last point back to the first
  Region out;
  for (std::size_t i = 0; i < edges.size(); ++i)
    append_land_near(edges[i], i + 1 < edges.size() ? &edges[i + 1] : nullptr, distance_m, out);
  return out;
}

double arcs_about_corners_m(const Ring& ring, double distance_m) {
  const std::vector<RingEdge> edges = edges_of(ring);
  double sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    sum += distance_m * turn_out(edges[i], edges[i + 1 < edges.size() ? i + 1 : 0]);
  return sum;
}

}  // namespace tramline::check
