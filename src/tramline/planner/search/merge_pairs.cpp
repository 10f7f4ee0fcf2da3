#include "tramline/planner/search/merge_pairs.h"

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {

std::optional<Polygon> merged_shape(const Polygon& a, const Polygon& b) {
  if (!intersects(bounds(a), bounds(b))) return std::nullopt;
  Region both = unite({a}, {b});
  if (both.size() != 1) return std::nullopt;
  return std::move(both.front());
}

}  // namespace tramline
