#include "tramline/admission/unite_obstacles.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/admission/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline {
namespace {

std::string verdict(const Obstacle& first, const Obstacle& second, double common_m2) {
  const bool second_inside = area(second.shape) - common_m2 <= kNoArea_m2;
  const bool first_inside = area(first.shape) - common_m2 <= kNoArea_m2;
  if (first_inside && second_inside)
    return fmt::format("{} repeats {}; it was dropped", second.origin, first.origin);
  if (second_inside) return fmt::format("{} lies inside {}; it was dropped", second.origin, first.origin);
  if (first_inside) return fmt::format("{} lies inside {}; it was dropped", first.origin, second.origin);
  return fmt::format("{} and {} overlap by {:.3f} m²; they were united", first.origin, second.origin,
                     common_m2);
}

/// Precondition: the two overlap by common_m2.
Obstacle united(const Obstacle& first, const Obstacle& second, double common_m2) {
  if (area(second.shape) - common_m2 <= kNoArea_m2) return first;
  if (area(first.shape) - common_m2 <= kNoArea_m2) return second;
  Region both = unite({first.shape}, {second.shape});
  // Two overlapping polygons make one; anything else is dust of the grid.
  std::stable_sort(both.begin(), both.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  return {both.front(), first.kind, first.origin + " + " + second.origin};
}

}  // namespace

std::vector<Obstacle> unite_obstacles(std::vector<Obstacle> obstacles, RepairLog* repair_log) {
  std::vector<Obstacle> out;
  for (Obstacle& next : obstacles) {
    Obstacle current = std::move(next);
    for (std::size_t i = 0; i < out.size();) {
      if (!intersects(bounds(out[i].shape), bounds(current.shape))) {
        ++i;
        continue;
      }
      const Region common = intersection({out[i].shape}, {current.shape});
      const double common_m2 = area(common);
      if (common_m2 <= kNoArea_m2) {
        ++i;
        continue;
      }
      if (repair_log != nullptr)
        repair_log->repair(verdict(out[i], current, common_m2), current.origin,
                           interior_point(common.front()), common_m2);
      current = united(out[i], current, common_m2);
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
      // The union may reach obstacles that neither of the two reached alone.
      i = 0;
    }
    out.push_back(std::move(current));
  }
  return out;
}

}  // namespace tramline
