#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/land_faults.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

double extent_m(const Polygon& polygon) {
  double out = 0;
  for (const Point a : polygon.outer)
    for (const Point b : polygon.outer) out = std::max(out, distance(a, b));
  return out;
}

double least_track_m(const Plan& plan) {
  return std::max(min_length_m(plan.machine), 2 * plan.machine.width_m);
}

/// Whether a part is so wide somewhere, so long, and large enough for both.
bool holds_strip(const Polygon& part, double width_m, double length_m) {
  return area(part) >= width_m * length_m && extent_m(part) >= length_m &&
         !buffered({part}, -0.5 * width_m).empty();
}

/// Chords, and the grid of polygon booleans, make parts a little smaller or larger: no room for swaths of
/// this share of the width and the least length is none for certain, and room for swaths of that one is room
/// for certain.
constexpr double kNone = 0.97, kCertain = 1.03;

/// The parts without room for a swath of such a share, that are not strips of a third of the width and twice
/// the least length of a track either.
Region without_room(const Region& parts, const Plan& plan, double share) {
  const double wide_m = share * plan.machine.width_m, long_m = share * least_track_m(plan);
  Region out = parts;
  std::erase_if(out, [&](const Polygon& part) {
    return holds_strip(part, wide_m, long_m) || holds_strip(part, wide_m / 3, 2 * long_m);
  });
  return out;
}

/// With headlands along some edges: the parts of the body far from boundaries that may be too small for a
/// track by themselves. They are left to tracks together with the headland ground beside them.
Region small_parts_of_body(const Case& c) {
  if (c.plan.headland.edge_passes.empty()) return {};
  // Parts that hang together by less than twice this, m, are apart: chords of arcs may join them.
  constexpr double kNeck_m = 0.1;
  const Region far = difference(c.plan.body, c.near_boundaries);
  return without_room(buffered(buffered(far, -kNeck_m), 1.1 * kNeck_m), c.plan, kCertain);
}

/// The land that remains after it is made narrower by more than a swath on all sides, where it is long enough
/// for a track by itself.
Region with_ample_room(const Region& ground, const Plan& plan) {
  constexpr double kHalf = 0.55;
  Region out = buffered(ground, -kHalf * plan.machine.width_m);
  std::erase_if(out, [&](const Polygon& part) { return extent_m(part) < least_track_m(plan); });
  return out;
}

}  // namespace

void check_ceded_to_tracks(const Case& c, Violations& out) {
  if (is_repair(c.plan) || c.near_boundaries.empty()) return;
  const Region left = intersection(c.plan.body, c.near_boundaries);
  const double tolerance_m2 = c.area_tolerance_m2 + c.round_edges_m2;
  if (c.plan.headland.construction == HeadlandConstruction::kPlain) {
    report_land(Rule::kBody, left, tolerance_m2,
                "{:.3f} m² of the body are nearer to a boundary than its plain passes are wide", out);
    return;
  }
  if (area(left) <= tolerance_m2 && c.plan.headland.unworked.empty()) return;
  Region bands;
  double all_arcs_m = 0;
  for (const HeadlandPass& pass : c.plan.headland.passes) {
    Region more = flat_bands_along(pass.path, c.plan.machine.width_m, kLayerSagitta);
    bands.insert(bands.end(), more.begin(), more.end());
    all_arcs_m += arcs_m(pass.path);
  }
  const double drawn_m2 = tolerance_m2 + kRoundEdge_m * 2 * all_arcs_m;
  const Region worked = unite(bands);
  report_land(Rule::kBody, intersection(left, worked), drawn_m2,
              "headland passes work {:.3f} m² that are left to tracks", out);
  report_land(Rule::kBody, intersection(left, c.along_boundaries), drawn_m2,
              "{:.3f} m² left to tracks lie next to a boundary", out);
  report_land(Rule::kBody,
              intersection(without_room(unite(left, small_parts_of_body(c)), c.plan, kNone), left), drawn_m2,
              "{:.3f} m² are left to tracks where none has room", out);
  const Region idle = difference(difference(c.plan.headland.ground, worked), c.along_boundaries);
  report_land(Rule::kBody, with_ample_room(idle, c.plan), 0,
              "tracks have room in {:.3f} m² of the headland that no pass works", out);
}

}  // namespace tramline::check
