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

/// Halves the path until no part meets itself.
void append_parts(const Path& path, double width_m, std::vector<Path>& out) {
  if (path.size() == 1 || !meets_itself(path, width_m)) {
    out.push_back(path);
    return;
  }
  const auto middle = path.begin() + static_cast<std::ptrdiff_t>(path.size() / 2);
  append_parts(Path(path.begin(), middle), width_m, out);
  append_parts(Path(middle, path.end()), width_m, out);
}

Region bands(const Path& path, double width_m) {
  if (!meets_itself(path, width_m)) return {closed_band(path, width_m, kBodySagitta)};
  std::vector<Path> parts;
  append_parts(path, width_m, parts);
  Region out;
  for (const Path& part : parts) out.push_back({band(part, width_m, kBodySagitta), {}});
  return out;
}

/// What of the ground the pass leaves. Bands whose inner edge shrinks to points may fold there by rounding,
/// which the polygon engine does not always digest: a little narrower they do not.
Region left_by(const Path& path, double width_m, const Region& ground) {
  constexpr int kTries = 4;
  for (int i = 0;; ++i) {
    try {
      Region left = ground;
      for (const Polygon& band : bands(path, width_m - i * 0.25 * kLayerSagitta))
        left = difference(left, {band});
      return left;
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
