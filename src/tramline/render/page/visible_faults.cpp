#include "tramline/render/page/visible_faults.h"

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::render {
namespace {

constexpr double kLeastWidth = 1e-3;

bool is_convex(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  const std::size_t n = ring.size();
  if (!polygon.holes.empty()) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return true;
}

// Without its parts thinner than kLeastWidth: a gap of micrometres between two swaths may hang on to a
// real fault as a tail.
Region without_tails(const Polygon& polygon) {
  if (is_convex(polygon)) return {polygon};
  const Region core = buffered({polygon}, -0.5 * kLeastWidth, JoinStyle::kMitre);
  return core.empty() ? core : buffered(core, 0.5 * kLeastWidth, JoinStyle::kMitre);
}

}  // namespace

double mean_width(const Polygon& polygon) {
  double around = perimeter(polygon.outer);
  for (const Ring& hole : polygon.holes) around += perimeter(hole);
  return around > 0 ? 2 * area(polygon) / around : 0;
}

Region visible_faults(const Region& faults) {
  Region out;
  for (const Polygon& fault : faults)
    for (const Polygon& polygon : without_tails(fault))
      if (mean_width(polygon) >= kLeastWidth) out.push_back(polygon);
  return out;
}

}  // namespace tramline::render
