#include "tramline/headland/pass_tally.h"

#include <algorithm>

#include "tramline/geometry/path/newly_covered_area.h"

namespace tramline {
namespace {

void append_region(const Region& region, const Box& window, RisingCurves& out) {
  for (const Ring& ring : rings_of(region)) append_ring(ring, Layer::kBody, window, out);
}

double worked_on(const Region& passable, const HeadlandPass& pass, double width_m) {
  RisingCurves curves;
  append_region(passable, reach_of(pass.path, width_m), curves);
  append_swath_area(pass.path, width_m, Layer::kNew, curves);
  return newly_covered_area(curves);
}

}  // namespace

void tally_passes(const Region& passable, double width_m, Headland& headland) {
  RisingCurves curves;
  Box window = bounds(headland.ground);
  headland.worked_m2 = 0;
  for (const HeadlandPass& pass : headland.passes) {
    window.extend(reach_of(pass.path, width_m));
    append_swath_area(pass.path, width_m, Layer::kNew, curves);
    headland.worked_m2 += width_m * length(pass.path);
    if (!passable.empty()) headland.worked_m2 -= worked_on(passable, pass, width_m);
  }
  append_region(headland.ground, window, curves);
  const double covered = newly_covered_area(curves);
  headland.overlap_m2 = std::max(0.0, headland.worked_m2 - covered);
  headland.uncovered_m2 = std::max(0.0, area(headland.ground) - covered);
}

}  // namespace tramline
