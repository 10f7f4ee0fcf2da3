#include "tramline/headland/pass_ground.h"

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/headland/tolerances.h"
#include "tramline/model/headland.h"

namespace tramline {
namespace {

/// Whether it works some land twice by itself.
bool meets_itself(const Path& path, double width_m) {
  RisingCurves curves;
  const Box reach = reach_of(path, width_m);
  append_box(reach.grown(1), Layer::kBody, reach, curves);
  append_band(path, width_m, Layer::kNew, curves);
  return newly_covered_area(curves) < width_m * length(path) - kSelfOverlap_m2;
}

}  // namespace

Region pass_ground_parts(const Path& path, double width_m, double sagitta_m) {
  if (has_kinks(path)) {
    Region cells;
    for (Ring& cell : kinked_cells(path, width_m)) cells.push_back({std::move(cell), {}});
    return cells;
  }
  if (!meets_itself(path, width_m)) return {swath({path, 1, false, {}}, width_m, sagitta_m)};
  Region out;
  for (const PathSegment& segment : path) out.push_back({band({segment}, width_m, sagitta_m), {}});
  return out;
}

}  // namespace tramline
