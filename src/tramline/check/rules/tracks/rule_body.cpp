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
    report_land(Rule::kBody, difference(difference(land, c.near_boundaries), c.plan.body), tolerance_m2,
                "the body lacks {:.3f} m² of the field less its obstacles and headlands", out);
    report_land(Rule::kBody, difference(c.plan.headland.ground, c.near_boundaries), tolerance_m2,
                "{:.3f} m² of the headland are farther from boundaries than its passes are wide", out);
    check_parting(c, c.plan.headland.ground, "headland", land, out);
  }
  report_land(Rule::kBody, difference(c.plan.given_up, c.near_boundaries.empty() ? land : c.plan.body),
              c.area_tolerance_m2, "{:.3f} m² of the land given up lie outside the body", out);
}

}  // namespace tramline::check
