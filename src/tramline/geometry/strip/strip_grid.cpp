#include "tramline/geometry/strip/strip_grid.h"

namespace tramline {

StripRange strips_over(const StripGrid& grid, const Box& turned, double slack_m) {
  if (turned.empty() || turned.width() <= 2 * slack_m) return {};
  return {grid.strip_at(turned.min_x + slack_m), grid.strip_at(turned.max_x - slack_m)};
}

}  // namespace tramline
