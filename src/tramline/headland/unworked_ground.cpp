#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/layered_area.h"
#include "tramline/headland/headland.h"

namespace tramline {
namespace {

/// Does it work some ground twice by itself?
bool meets_itself(const Path& path, double width_m) {
  constexpr double kRounding = 1e-6;  // m²
  RisingCurves curves;
  const Box reach = reach_of(path, width_m);
  append_box(reach.grown(1), Layer::kBody, reach, curves);
  append_band(path, width_m, Layer::kNew, curves);
  return new_area(curves) < width_m * length(path) - kRounding;
}

Region bands(const Path& path, double width_m) {
  if (!meets_itself(path, width_m)) return {closed_band(path, width_m, kBodySagitta)};
  Region out;
  for (const PathSegment& segment : path) out.push_back({band({segment}, width_m, kBodySagitta), {}});
  return unite(out);
}

/// What of the ground the pass leaves. Bands whose inner edge shrinks to points may fold there by rounding,
/// which the polygon engine does not always digest: a little narrower they do not.
Region left_by(const Path& path, double width_m, const Region& ground) {
  constexpr int kTries = 4;
  for (int i = 0;; ++i) {
    try {
      return difference(ground, bands(path, width_m - i * 0.25 * kLayerSagitta));
    } catch (const Error&) {
      if (i == kTries) throw;
    }
  }
}

}  // namespace

Region unworked_ground(const Headland& headland, double width_m) {
  constexpr double kHair = 1e-3;  // m²: where bands meet
  Region out = headland.ground;
  for (const HeadlandPass& pass : headland.passes) out = left_by(pass.path, width_m, out);
  std::erase_if(out, [](const Polygon& part) { return area(part) < kHair; });
  return out;
}

}  // namespace tramline
