#include <fmt/format.h>

#include <string>

#include "tramline/check/rules/land_faults.h"
#include "tramline/check/rules/rules.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {

namespace {

/// Body and headland have the same chords along their common border: no land may be lost between the two.
void check_parting(const Case& c, const Region& ground, const std::string& name, const Region& land,
                   Violations& out) {
  report_land(Rule::kBody, intersection(c.plan.body, ground), c.area_tolerance_m2,
              "body and " + name + " overlap by {:.3f} m²", out);
  Region both = c.plan.body;
  both.insert(both.end(), ground.begin(), ground.end());
  report_land(Rule::kBody, symmetric_difference(unite(both), land), c.area_tolerance_m2,
              "body and " + name + " together differ from the field less its obstacles by {:.3f} m²", out);
}

/// Length of the border that a part has in common with the body, m, about.
double common_border_m(const Polygon& part, const Region& body) {
  constexpr double kReach_m = 0.01;
  return area(intersection(buffered({part}, kReach_m), body)) / kReach_m;
}

bool has_room(const Polygon& part, double width_m, double long_m) {
  // Allowing for mitred corners, chords and the grid.
  constexpr double kShare = 1.03, kNarrow = 1.0 / 3;
  double extent_m = 0;
  for (const Point a : part.outer)
    for (const Point b : part.outer) extent_m = std::max(extent_m, distance(a, b));
  const double strips = area(part) / (kShare * kShare * width_m * long_m);
  const auto holds = [&](double strip_m, double length_m) {
    return extent_m > kShare * length_m && !buffered({part}, -0.5 * kShare * strip_m).empty();
  };
  return (strips > 1 && holds(width_m, long_m)) ||
         (strips > 2 * kNarrow && holds(kNarrow * width_m, 2 * long_m));
}

/// With headlands along some edges: the parts of the land far from them that are too small for a track, and
/// hang together with the rest of it nowhere.
Region given_to_headland(const Case& c, const Region& far) {
  if (c.plan.headland.edge_passes.empty()) return {};
  constexpr double kNeck = 0.5;  // widths
  const double width_m = c.plan.machine.width_m;
  const double long_m = std::max(min_length_m(c.plan.machine), 2 * width_m);
  Region out = difference(far, c.plan.body);
  // Headland left to tracks may lie beside such parts.
  const Region rest = intersection(far, c.plan.body);
  std::erase_if(out, [&](const Polygon& part) {
    return has_room(part, width_m, long_m) || common_border_m(part, rest) > kNeck * width_m;
  });
  return out;
}

}  // namespace

void check_body(const Case& c, Violations& out) {
  Region obstacles;
  for (const Obstacle& obstacle : c.plan.field.obstacles) obstacles.push_back(obstacle.shape);
  const Region land = difference({{c.plan.field.outer, {}}}, unite(obstacles));
  if (!c.plan.worked.empty()) {
    check_parting(c, c.plan.worked, "worked ground", land, out);
    if (!is_repair(c.plan))
      report_land(Rule::kBody, difference(c.plan.given_up, c.plan.body), c.area_tolerance_m2,
                  "{:.3f} m² of the land given up lie outside the body", out);
    return;
  }
  if (is_of_lines(c.plan) && !c.plan.headland.ground.empty()) {
    check_parting(c, c.plan.headland.ground, "headland", land, out);
  } else if (c.near_boundaries.empty() && c.plan.headland.ground.empty()) {
    report_land(Rule::kBody, symmetric_difference(land, c.plan.body), c.area_tolerance_m2,
                "the body differs from the field less its obstacles by {:.3f} m²", out);
  } else {
    const double tolerance_m2 = c.area_tolerance_m2 + c.round_edges_m2;
    const Region far = difference(land, c.near_boundaries), given = given_to_headland(c, far);
    report_land(Rule::kBody, difference(difference(far, given), c.plan.body), tolerance_m2,
                "the body lacks {:.3f} m² of the field less its obstacles and headlands", out);
    report_land(Rule::kBody, difference(difference(c.plan.headland.ground, c.near_boundaries), given),
                tolerance_m2,
                "{:.3f} m² of the headland are farther from boundaries than its passes are wide", out);
    check_parting(c, c.plan.headland.ground, "headland", land, out);
  }
  report_land(Rule::kBody, difference(c.plan.given_up, c.near_boundaries.empty() ? land : c.plan.body),
              c.area_tolerance_m2, "{:.3f} m² of the land given up lie outside the body", out);
}

}  // namespace tramline::check
