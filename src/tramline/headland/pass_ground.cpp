#include "tramline/headland/pass_ground.h"

#include <iterator>

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

/// Stretches of the path that do not meet themselves, by halves.
void append_parts(const Path& path, double width_m, double sagitta_m, Region& parts) {
  if (path.size() == 1) {
    parts.push_back({band(path, width_m, sagitta_m), {}});
  } else if (!meets_itself(path, width_m)) {
    parts.push_back(swath({path, 1, false, {}}, width_m, sagitta_m));
  } else {
    const auto middle = path.begin() + std::ssize(path) / 2;
    append_parts({path.begin(), middle}, width_m, sagitta_m, parts);
    append_parts({middle, path.end()}, width_m, sagitta_m, parts);
  }
}

}  // namespace

Region pass_ground_parts(const Path& path, double width_m, double sagitta_m) {
  if (has_kinks(path)) {
    Region cells;
    for (Ring& cell : kinked_cells(path, width_m)) cells.push_back({std::move(cell), {}});
    return cells;
  }
  Region out;
  append_parts(path, width_m, sagitta_m, out);
  return out;
}

}  // namespace tramline
