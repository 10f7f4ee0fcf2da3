#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/headland.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// The ground that the pass leaves. Bands whose inner edge shrinks to points may fold there by rounding,
/// which the polygon engine does not always accept; slightly narrower ones do not fold.
Region unworked_by(const HeadlandPass& pass, double width_m, const Region& ground) {
  constexpr int kTries = 4;
  for (int i = 0;; ++i) {
    try {
      return difference(
          ground, unite(pass_ground_parts(pass.path, width_m - i * 0.25 * kLayerSagitta, kBodySagitta)));
    } catch (const Error& error) {
      if (i == kTries || error.kind() != ErrorKind::kFailure) throw;
    }
  }
}

}  // namespace

Region unworked_ground(const Headland& headland, double width_m) {
  Region out = headland.ground;
  for (const HeadlandPass& pass : headland.passes) out = unworked_by(pass, width_m, out);
  std::erase_if(out, [](const Polygon& part) { return area(part) < kBandsMeet_m2; });
  return out;
}

}  // namespace tramline
