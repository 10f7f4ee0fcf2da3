#include <fmt/format.h>

#include <cmath>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

bool usable(const Ring& ring) {
  if (ring.size() < 3) return false;
  for (const Point p : ring)
    if (!(std::abs(p.x) <= kFarthest_m) || !(std::abs(p.y) <= kFarthest_m)) return false;
  return true;
}

void check_polygon(const Polygon& polygon, const std::string& name, Violations& out) {
  bool all_usable = usable(polygon.outer);
  for (const Ring& hole : polygon.holes) all_usable = all_usable && usable(hole);
  if (!all_usable) {
    out.push_back(
        {Rule::kShapes, name + " has a ring of fewer than three vertices or a vertex off the map", {}, 0});
    return;
  }
  if (const auto fault = find_invalidity(polygon))
    out.push_back(
        {Rule::kShapes, fmt::format("{} is no valid polygon: {}", name, fault->reason), fault->place, 0});
}

void check_region(const Region& region, const char* name, Violations& out) {
  for (std::size_t i = 0; i < region.size(); ++i)
    check_polygon(region[i], fmt::format("polygon {} of {}", i + 1, name), out);
}

}  // namespace

void check_shapes(const Plan& plan, Violations& out) {
  check_polygon({plan.field.outer, {}}, "the field's outer ring", out);
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i)
    check_polygon(plan.field.obstacles[i].shape, fmt::format("obstacle {}", i + 1), out);
  for (std::size_t i = 0; i < plan.subfields.size(); ++i)
    check_polygon(plan.subfields[i].shape, fmt::format("subfield {}", i + 1), out);
  check_region(plan.body, "the body", out);
  check_region(plan.worked, "the worked ground", out);
  check_region(plan.given_up, "the land given up", out);
  check_region(plan.overlap, "the layer overlap", out);
  check_region(plan.uncovered, "the layer uncovered", out);
  check_region(plan.headland.ground, "the headland", out);
  check_region(plan.headland.unworked, "what the headland's passes leave", out);
}

}  // namespace tramline::check
