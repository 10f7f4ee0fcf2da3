#include "tramline/decomposition/divisions.h"

#include <algorithm>
#include <cmath>

#include "tramline/decomposition/tolerances.h"
#include "tramline/geometry/polygon/significant_vertices.h"

namespace tramline {
namespace {

struct Corner {
  SplitEvent event;
  Direction in, out;  ///< of the simplified edges that meet there
  double weight = 0;
};

void append_corners(const Ring& ring, double tolerance_m, std::vector<Corner>& out) {
  const std::vector<std::size_t> kept = significant_vertices(ring, tolerance_m);
  const std::size_t n = ring.size(), m = kept.size();
  if (m < 3) return;
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t at = kept[i];
    const Point before = ring[kept[(i + m - 1) % m]], vertex = ring[at], after = ring[kept[(i + 1) % m]];
    const Point in = vertex - before, next = after - vertex;
    const double turn = -std::atan2(cross(in, next), dot(in, next));
    if (turn <= Angle::degrees(5).radians()) continue;
    const SplitEvent event{ring[(at + n - 1) % n], vertex, ring[(at + 1) % n]};
    const double shorter = std::min(std::hypot(in.x, in.y), std::hypot(next.x, next.y));
    out.push_back({event, Direction::along(before, vertex), Direction::along(vertex, after),
                   std::min(turn, 1.5) * shorter});
  }
}

/// Adds the parts that the cuts divide the polygon into, if there are several.
bool add(const Polygon& polygon, const std::vector<Cut>& cuts, std::vector<Region>& out) {
  if (cuts.empty()) return false;
  Region parts = divided(polygon, cuts);
  const double whole = area(polygon);
  if (parts.size() < 2 || std::abs(area(parts) - whole) > kSameArea_share * whole) return false;
  out.push_back(std::move(parts));
  return true;
}

void add_corner(const Polygon& polygon, const Corner& corner, Direction driving, std::vector<Region>& out) {
  std::vector<Direction> tried;
  for (const Direction direction : {corner.in, corner.out, driving}) {
    const bool known = std::any_of(tried.begin(), tried.end(), [&](Direction other) {
      return angle_between(direction, other) < Angle::degrees(1);
    });
    if (known) continue;
    tried.push_back(direction);
    const std::vector<Cut> cuts = cuts_at(polygon, {corner.event}, direction);
    bool divides = false;
    for (const Cut& cut : cuts) divides = add(polygon, {cut}, out) || divides;
    if (!divides && cuts.size() > 1) add(polygon, cuts, out);
  }
}

/// The vertex that lies farthest along the direction, or farthest against it.
SplitEvent extreme(const Ring& ring, Direction direction, int sense) {
  std::size_t best = 0;
  const Point unit = direction.unit();
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (sense * dot(ring[i] - ring[best], unit) > 0) best = i;
  const std::size_t n = ring.size();
  return {ring[(best + n - 1) % n], ring[best], ring[(best + 1) % n]};
}

void add_hole(const Polygon& polygon, const Ring& hole, Direction direction, std::vector<Region>& out) {
  std::vector<Cut> cuts;
  for (const int sense : {-1, 1}) {
    const SplitEvent end = extreme(hole, direction, sense);
    for (const Cut& cut : cuts_at(polygon, {end}, direction))
      if (sense * dot(cut.to - cut.from, direction.unit()) > 0) cuts.push_back(cut);
  }
  if (cuts.size() == 2) add(polygon, cuts, out);
}

}  // namespace

std::vector<Region> divisions(const Polygon& polygon, const DivisionTerms& terms) {
  std::vector<Corner> corners;
  append_corners(polygon.outer, terms.tolerance_m, corners);
  for (const Ring& hole : polygon.holes) append_corners(hole, terms.tolerance_m, corners);
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.weight > b.weight; });
  if (corners.size() > terms.most_corners) corners.resize(terms.most_corners);
  std::vector<Region> out;
  for (const Corner& corner : corners) add_corner(polygon, corner, terms.driving, out);

  std::vector<const Ring*> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(&hole);
  std::stable_sort(holes.begin(), holes.end(), [](const Ring* a, const Ring* b) {
    return std::abs(signed_area(*a)) > std::abs(signed_area(*b));
  });
  if (holes.size() > terms.most_holes) holes.resize(terms.most_holes);
  for (const Ring* hole : holes)
    for (const Direction direction : {terms.driving, terms.driving.perpendicular()})
      add_hole(polygon, *hole, direction, out);
  return out;
}

}  // namespace tramline
