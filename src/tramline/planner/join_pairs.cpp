#include "tramline/planner/join_pairs.h"

#include "tramline/geometry/boolean.h"

namespace tramline {

std::optional<Polygon> joined_shape(const Polygon& a, const Polygon& b) {
  if (!intersects(bounds(a), bounds(b))) return std::nullopt;
  Region both = unite({a}, {b});
  if (both.size() != 1) return std::nullopt;
  return std::move(both.front());
}

}  // namespace tramline
