#include "tramline/planner/given/narrow_tails.h"

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/tolerances.h"

namespace tramline {

Region narrow_tails(const Polygon& polygon, double narrow_m, double long_m) {
  constexpr double kGrown_m = 1e-3;  // no hairline remains between the land and what the disc reaches
  const Region core = buffered({polygon}, -0.5 * narrow_m, JoinStyle::kMitre);
  Region out = core.empty()
                   ? Region{polygon}
                   : difference({polygon}, buffered(core, 0.5 * narrow_m + kGrown_m, JoinStyle::kMitre));
  std::erase_if(out, [&](const Polygon& tail) {
    return area(tail) < kNoGround_m2 || 0.5 * perimeter(tail.outer) < long_m;
  });
  return out;
}

}  // namespace tramline
