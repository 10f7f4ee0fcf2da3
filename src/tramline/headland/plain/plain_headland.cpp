#include "tramline/headland/plain/plain_headland.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/offset/mitred_offset.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/pass_tally.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// A boundary with its offsets: the land within the field's, or the land that an obstacle takes.
class Nested {
 public:
  Nested(const Boundary& boundary, double width_m) : boundary_(boundary), width_m_(width_m) {
    const Region whole{{obstacle() ? reversed(boundary.ring) : boundary.ring, {}}};
    Region last = whole;
    for (int i = 1; i <= boundary.passes; ++i) {
      last = moved_by(last, i == 1 ? boundary.clearance_m + 0.5 * width_m : width_m);
      centres_.push_back(last);
    }
    border_ = boundary.passes > 0 ? moved_by(last, 0.5 * width_m) : whole;
    const double kept_m = boundary.passes > 0 ? 0 : boundary.clearance_m;
    centres_.push_back(moved_by(border_, kept_m + 0.5 * width_m));
  }

  bool obstacle() const { return boundary_.obstacle.has_value(); }
  const Boundary& boundary() const { return boundary_; }
  /// Where centre lines with this number keep to: of the pass or, without one, half a width behind the
  /// border.
  const Region& centre(int number) const {
    return centres_[static_cast<std::size_t>(std::min(number, boundary_.passes + 1)) - 1];
  }
  const Region& border() const { return border_; }

 private:
  Region moved_by(const Region& region, double distance_m) const {
    if (region.empty()) return region;
    return obstacle() ? mitred_outset(region, distance_m) : mitred_inset(region, distance_m);
  }

  const Boundary& boundary_;
  double width_m_;
  std::vector<Region> centres_;
  Region border_;
};

/// The land within the first of the shapes and in none of the others.
template <class Shape>
Region within(const std::vector<Nested>& boundaries, Shape shape) {
  Region taken;
  for (const Nested& boundary : boundaries)
    if (boundary.obstacle())
      for (const Polygon& part : shape(boundary)) taken.push_back(part);
  return without_slivers(difference(shape(boundaries.front()), unite(taken)));
}

bool lies_on(Point p, const Region& region) {
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (distance_to_edge({ring[i], ring[(i + 1) % ring.size()], 0}, p, p) <= kOnPlainRing_m) return true;
  return false;
}

/// From the middle of the longest edge round to it.
Path closed_from_longest_edge(const Ring& ring) {
  std::size_t longest = 0;
  double most_m = 0;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double length_m = distance(ring[i], ring[(i + 1) % n]);
    if (length_m <= most_m) continue;
    most_m = length_m;
    longest = i;
  }
  const Point middle = midpoint(ring[longest], ring[(longest + 1) % n]);
  std::vector<Point> line{middle};
  for (std::size_t i = 1; i <= n; ++i) line.push_back(ring[(longest + i) % n]);
  line.push_back(middle);
  return polyline_path(line);
}

/// The pass along a ring; without a path where no boundary that it follows has so many.
HeadlandPass pass_along(const Ring& ring, const std::vector<Nested>& boundaries, int number) {
  HeadlandPass out{{}, number, false, {}};
  bool asked_for = false;
  for (const Nested& nested : boundaries) {
    bool follows = false;
    for (std::size_t i = 0; i < ring.size() && !follows; ++i)
      follows = lies_on(midpoint(ring[i], ring[(i + 1) % ring.size()]), nested.centre(number));
    if (!follows) continue;
    asked_for = asked_for || nested.boundary().passes >= number;
    if (nested.obstacle())
      out.obstacles.push_back(*nested.boundary().obstacle);
    else
      out.around_field = true;
  }
  if (asked_for) out.path = closed_from_longest_edge(ring);
  return out;
}

}  // namespace

HeadlandAndBody plain_headland_of(const Field& field, const HeadlandTerms& terms) {
  const std::vector<Boundary> boundaries = boundaries_of(field, terms);
  std::vector<Nested> nested;
  int most = 0;
  for (const Boundary& boundary : boundaries) {
    most = std::max(most, boundary.passes);
    nested.emplace_back(boundary, terms.width_m);
  }
  const Region land = body_of(field);
  HeadlandAndBody out;
  out.construction = HeadlandConstruction::kPlain;
  out.obstacle_passes = terms.obstacle_passes;
  const Region behind = within(nested, [](const Nested& b) { return b.border(); });
  out.body = without_slivers(intersection(land, unite(behind, land_inside_obstacles(field, boundaries))));
  out.ground = difference(land, out.body);
  for (int number = 1; number <= most; ++number)
    for (const Polygon& part : within(nested, [number](const Nested& b) { return b.centre(number); })) {
      if (area(part) < kNoGain_m2) continue;
      for (const Ring& whole : rings_of({part})) {
        const Ring ring = without_idle_corners(whole);
        if (ring.empty()) continue;
        HeadlandPass pass = pass_along(ring, nested, number);
        if (!pass.path.empty()) out.passes.push_back(std::move(pass));
      }
    }
  tally_passes(obstacle_shapes(field, ObstacleKind::kPassable), terms.width_m, out);
  return out;
}

}  // namespace tramline
