#include "tramline/check/file/compare_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// Frames come through text in files: the last digits of degrees do not count (1e-11° are 1 µm).
bool same_frame(const LocalFrame& a, const LocalFrame& b) {
  constexpr double kSame_deg = 1e-11;
  return a.geodetic == b.geodetic &&
         (!a.geodetic || (std::abs(a.origin_lon_deg - b.origin_lon_deg) <= kSame_deg &&
                          std::abs(a.origin_lat_deg - b.origin_lat_deg) <= kSame_deg));
}

Ring shifted(Ring ring, Point by) {
  for (Point& p : ring) p = p + by;
  return ring;
}

Region obstacles(const Field& field, ObstacleKind kind, Point shift) {
  Region out;
  for (const Obstacle& obstacle : field.obstacles) {
    if (obstacle.kind != kind) continue;
    out.push_back({shifted(obstacle.shape.outer, shift), {}});
    for (const Ring& hole : obstacle.shape.holes) out.back().holes.push_back(shifted(hole, shift));
  }
  return unite(out);
}

double total_perimeter(const Region& region) {
  double sum = 0;
  for (const Ring& ring : rings_of(region)) sum += perimeter(ring);
  return sum;
}

void compare_regions(const Region& planned, const Region& input, const char* name,
                     std::vector<Violation>& out) {
  const Region off = symmetric_difference(planned, input);
  const double amount = area(off);
  const double tolerance = std::max(kAreaShare * std::max(area(planned), area(input)),
                                    kGridSize * (total_perimeter(planned) + total_perimeter(input)));
  if (amount > tolerance)
    out.push_back({Rule::kField,
                   fmt::format("{} of the plan and of the input differ by {:.3f} m²", name, amount),
                   point_on_largest(off), amount});
}

/// Compares the repairs and warnings of admission: the same input has to give the same ones.
void compare_reports(const Field& planned, const Field& input, std::vector<Violation>& out) {
  const auto same = [](const Repair& a, const Repair& b) { return a.what == b.what && a.where == b.where; };
  if (!std::equal(planned.repairs.begin(), planned.repairs.end(), input.repairs.begin(), input.repairs.end(),
                  same))
    out.push_back(
        {Rule::kField,
         fmt::format("the plan lists {} repairs of the field, but the input needs {}, or different ones",
                     planned.repairs.size(), input.repairs.size()),
         planned.outer.front(), 1});
  if (planned.warnings != input.warnings)
    out.push_back(
        {Rule::kField,
         fmt::format("the plan has {} warnings about the field, but the input gives {}, or different ones",
                     planned.warnings.size(), input.warnings.size()),
         planned.outer.front(), 1});
}

}  // namespace

std::vector<Violation> compare_fields(const Field& planned, const Field& input) {
  if (!same_frame(planned.frame, input.frame))
    return {{Rule::kField, "the plan lies in another local frame than the input", {}, 0}};
  std::vector<Violation> out;
  Point shift;
  if (!planned.frame.geodetic)
    shift = {input.frame.origin_x_m - planned.frame.origin_x_m,
             input.frame.origin_y_m - planned.frame.origin_y_m};
  compare_regions(unite(Region{{planned.outer, {}}}), unite(Region{{shifted(input.outer, shift), {}}}),
                  "the outer rings", out);
  compare_regions(obstacles(planned, ObstacleKind::kObstacle, {}),
                  obstacles(input, ObstacleKind::kObstacle, shift), "the obstacles", out);
  compare_regions(obstacles(planned, ObstacleKind::kPassable, {}),
                  obstacles(input, ObstacleKind::kPassable, shift), "the passable obstacles", out);
  compare_reports(planned, input, out);
  return out;
}

}  // namespace tramline::check
