#include "tramline/geometry/offset/mitred_offset.h"

#include <cassert>
#include <cmath>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/significant_vertices.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The land between two edges that part at a corner: the kite up to their mitre, or cut at the distance.
Ring corner_between(Point corner, Point before, Point after, double distance_m) {
  const Point first = distance_m * left_of(before), last = distance_m * left_of(after);
  constexpr double kSharpest = -0.5;  // cosine of 120°
  if (dot(before, after) >= kSharpest) {
    const Point tip = (1 / (1 + dot(before, after))) * (left_of(before) + left_of(after));
    return {corner, corner + last, corner + distance_m * tip, corner + first};
  }
  // tan(τ/4) along both edges, on the line across the middle of the turn.
  const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
  const double on_m = distance_m * std::tan(0.25 * turn);
  return {corner, corner + last, corner + last - on_m * after, corner + first + on_m * before,
          corner + first};
}

/// What the edges of the ring pass over as they move to its left.
void append_passed_over(const Ring& whole, double distance_m, Region& out) {
  const Ring ring = without_idle_corners(whole);
  const std::size_t n = ring.size();
  const auto along = [&](std::size_t i) {
    const Point edge = ring[(i + 1) % n] - ring[i % n];
    return (1 / length(edge)) * edge;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point from = ring[i], to = ring[(i + 1) % n], aside = distance_m * left_of(along(i));
    out.push_back({{from, to, to + aside, from + aside}, {}});
    const Point before = along(i), after = along(i + 1);
    if (cross(before, after) < -kLeastKink_rad || (dot(before, after) < 0 && cross(before, after) <= 0))
      out.push_back({corner_between(to, before, after, distance_m), {}});
  }
}

bool is_thin(const Ring& ring) {
  return without_idle_corners(ring).empty() || std::abs(signed_area(ring)) <= kMitredIdle_m * perimeter(ring);
}

}  // namespace

Region without_slivers(Region region) {
  std::erase_if(region, [](const Polygon& part) { return is_thin(part.outer); });
  for (Polygon& part : region) std::erase_if(part.holes, is_thin);
  return region;
}

Ring without_idle_corners(const Ring& ring) {
  Ring out;
  for (const std::size_t i : significant_vertices(ring, kMitredIdle_m)) out.push_back(ring[i]);
  if (out.size() < 3) out.clear();
  return out;
}

Region mitred_inset(const Region& region, double distance_m) {
  assert(distance_m > 0);
  Region passed;
  for (const Ring& ring : rings_of(region)) append_passed_over(ring, distance_m, passed);
  return without_slivers(difference(region, unite(passed)));
}

Region mitred_outset(const Region& region, double distance_m) {
  assert(distance_m > 0);
  Region all = region;
  for (const Ring& ring : rings_of(region)) append_passed_over(reversed(ring), distance_m, all);
  return without_slivers(unite(all));
}

}  // namespace tramline
