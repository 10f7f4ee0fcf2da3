#include "tramline/planner/headland_choice/divided_like.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "tramline/geometry/point.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"
#include "tramline/geometry/polygon/outline_distance.h"

namespace tramline {
namespace {

/// Ground smaller than this is no subfield by itself, where it adjoins another one, m²; and as little is
/// rounding, where it adjoins none.
constexpr double kSliver_m2 = 1, kRounding_m2 = 1e-3;
/// Outlines of two subfields run along one another where they are no farther apart, m.
constexpr double kOnSeam_m = 1e-3;

bool same_lines(const Subfield& a, const Subfield& b) {
  return a.direction == b.direction && a.reference == b.reference;
}

Subfield part_of(const Subfield& subfield, const Polygon& shape) {
  return {shape, subfield.direction, subfield.reference, subfield.given_by};
}

const Subfield& nearest_of(const std::vector<Subfield>& subfields, Point p) {
  return *std::ranges::min_element(
      subfields, {}, [&](const Subfield& subfield) { return distance_to_outline(p, subfield.shape); });
}

double farthest_m(const Region& rest, const std::vector<Subfield>& layout) {
  double out = 0;
  for (const Ring& ring : rings_of(rest))
    for (const Point corner : ring)
      out = std::max(out, distance_to_outline(corner, nearest_of(layout, corner).shape));
  return out;
}

/// The seams between subfields, each of their edges longer by so much at both ends.
std::vector<std::vector<Point>> seams_driven_on(const std::vector<Subfield>& layout, double by_m) {
  std::vector<std::vector<Point>> out;
  for (const Subfield& one : layout)
    for (const Ring& ring : rings_of({one.shape}))
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const Point middle = 0.5 * (a + b);
        const bool on_seam = std::ranges::any_of(layout, [&](const Subfield& other) {
          return &other != &one && distance_to_outline(middle, other.shape) <= kOnSeam_m;
        });
        if (!on_seam || a == b) continue;
        const Point on = (by_m / distance(a, b)) * (b - a);
        out.push_back({a - on, b + on});
      }
  return out;
}

/// Makes the shape part of the first of the subfields, the nearest first, that it adjoins along an edge.
bool joined(const Polygon& shape, std::vector<Subfield>& subfields) {
  const Point inside = interior_point(shape);
  std::vector<std::pair<double, Subfield*>> by_distance;
  for (Subfield& subfield : subfields)
    by_distance.emplace_back(distance_to_outline(inside, subfield.shape), &subfield);
  std::ranges::stable_sort(by_distance, {}, [](const auto& one) { return one.first; });
  return std::ranges::any_of(by_distance, [&](const auto& one) {
    Region both = unite({one.second->shape}, {shape});
    if (both.size() != 1) return false;
    one.second->shape = std::move(both.front());
    return true;
  });
}

}  // namespace

std::vector<Subfield> divided_like(const Region& ground, const std::vector<Subfield>& layout) {
  assert(!layout.empty());
  std::vector<Subfield> out;
  const bool undivided =
      std::ranges::all_of(layout, [&](const Subfield& one) { return same_lines(one, layout.front()); });
  if (undivided) {
    for (const Polygon& part : ground) out.push_back(part_of(layout.front(), part));
    return out;
  }
  std::vector<Subfield> slivers;
  Region rest = ground;
  for (const Subfield& subfield : layout) {
    for (const Polygon& part : intersection(ground, {subfield.shape}))
      (area(part) >= kSliver_m2 ? out : slivers).push_back(part_of(subfield, part));
    rest = difference(rest, {subfield.shape});
  }
  const auto smaller =
      std::partition(rest.begin(), rest.end(), [](const Polygon& part) { return area(part) >= kSliver_m2; });
  const Region beyond(rest.begin(), smaller);
  if (!beyond.empty()) {
    rest.erase(rest.begin(), smaller);
    const auto seams = seams_driven_on(layout, farthest_m(beyond, layout));
    for (const Polygon& part : beyond)
      for (Polygon& divided : split_by_lines(part, seams)) rest.push_back(std::move(divided));
  }
  for (const Polygon& part : rest) slivers.push_back(part_of(nearest_of(layout, interior_point(part)), part));
  for (Subfield& sliver : slivers)
    if (!joined(sliver.shape, out) && area(sliver.shape) >= kRounding_m2) out.push_back(std::move(sliver));
  return out;
}

}  // namespace tramline
