#include "tramline/render/visible_faults.h"

namespace tramline::render {
namespace {

constexpr double kLeastWidth = 1e-3;

// Of a long thin polygon the area is about half the perimeter times the width.
double mean_width(const Polygon& polygon) {
  double around = perimeter(polygon.outer);
  for (const Ring& hole : polygon.holes) around += perimeter(hole);
  return around > 0 ? 2 * area(polygon) / around : 0;
}

}  // namespace

Region visible_faults(const Region& faults) {
  Region out;
  for (const Polygon& polygon : faults)
    if (mean_width(polygon) >= kLeastWidth) out.push_back(polygon);
  return out;
}

}  // namespace tramline::render
