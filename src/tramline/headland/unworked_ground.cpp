#include <iterator>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/headland.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// The land that all passes work.
Region worked_by_passes(const Headland& headland, double width_m, double sagitta_m) {
  Region parts;
  for (const HeadlandPass& pass : headland.passes) {
    Region of_pass = pass_ground_parts(pass.path, width_m, sagitta_m);
    parts.insert(parts.end(), std::make_move_iterator(of_pass.begin()),
                 std::make_move_iterator(of_pass.end()));
  }
  return unite(parts);
}

/// Bands whose inner edge shrinks to points may fold there by rounding, which the polygon engine does not
/// always accept; slightly narrower ones do not fold.
Region without_passes(const Headland& headland, double width_m, double sagitta_m) {
  constexpr int kTries = 4;
  for (int i = 0;; ++i) {
    try {
      const double narrower_m = width_m - i * 0.25 * kLayerSagitta;
      return difference(headland.ground, worked_by_passes(headland, narrower_m, sagitta_m));
    } catch (const Error& error) {
      if (i == kTries || error.kind() != ErrorKind::kFailure) throw;
    }
  }
}

}  // namespace

Region unworked_ground(const Headland& headland, double width_m, double sagitta_m) {
  if (headland.passes.empty()) return headland.ground;
  Region out = without_passes(headland, width_m, sagitta_m);
  std::erase_if(out, [](const Polygon& part) { return area(part) < kBandsMeet_m2; });
  return out;
}

Region unworked_ground(const Headland& headland, double width_m) {
  return unworked_ground(headland, width_m, kBodySagitta);
}

}  // namespace tramline
