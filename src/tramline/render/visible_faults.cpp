#include "tramline/render/visible_faults.h"

namespace tramline::render {
namespace {

constexpr double kLeastWidth = 1e-3;

}  // namespace

double mean_width(const Polygon& polygon) {
  double around = perimeter(polygon.outer);
  for (const Ring& hole : polygon.holes) around += perimeter(hole);
  return around > 0 ? 2 * area(polygon) / around : 0;
}

Region visible_faults(const Region& faults) {
  Region out;
  for (const Polygon& polygon : faults)
    if (mean_width(polygon) >= kLeastWidth) out.push_back(polygon);
  return out;
}

}  // namespace tramline::render
