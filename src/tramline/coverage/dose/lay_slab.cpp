#include "tramline/coverage/dose/lay_slab.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline::coverage {
namespace {

/// No nozzle lays a line.
constexpr double kLeastDepth_m = 0.01;

Point unit_or(Point p, Point otherwise) {
  const double size = length(p);
  return size > 1e-12 ? (1 / size) * p : otherwise;
}

/// Where the machine hardly moved: about the middle of the bars, as wide as they are.
Quad strip(const Quad& q, double width_m) {
  const Point right = midpoint(q[1], q[2]), left = midpoint(q[0], q[3]);
  const Point across = unit_or(left - right, {0, 1});
  const Point ahead = 0.5 * kLeastDepth_m * Point{across.y, -across.x};
  const Point middle = midpoint(right, left);
  const Point half = 0.5 * std::max(width_m, kLeastDepth_m) * across;
  return {middle + half - ahead, middle - half - ahead, middle - half + ahead, middle + half + ahead};
}

/// From the right side of the slab to its left one, never negative within it.
EvenDensity density_of(const Slab& slab, const Quad& q) {
  const Point bar = (q[0] - q[1]) + (q[3] - q[2]);
  const Point way = (q[3] - q[0]) + (q[2] - q[1]);
  Point across = unit_or({-way.y, way.x}, unit_or(bar, {0, 1}));
  if (dot(across, bar) < 0) across = -1.0 * across;
  double low = dot(across, q[0]), high = low;
  for (const Point corner : q) {
    low = std::min(low, dot(across, corner));
    high = std::max(high, dot(across, corner));
  }
  if (!(high - low > 1e-9)) return {};
  const double slope = (slab.dense_left - slab.dense_right) / (high - low);
  return {slab.dense_right - slope * low, slope * across};
}

}  // namespace

void append_laid(const Slab& slab, double cell_m, std::vector<CellPart>& out) {
  assert(slab.amount > 0);
  Quad ground = slab.corners;
  std::vector<SmallPolygon> parts = convex_parts(ground);
  double area_m2 = 0;
  for (const SmallPolygon& part : parts) area_m2 += area(part);
  const double width_m = std::max(distance(ground[0], ground[1]), distance(ground[2], ground[3]));
  if (area_m2 < kLeastDepth_m * width_m || !(area_m2 > 0)) {
    ground = strip(ground, width_m);
    parts = convex_parts(ground);
  }
  const EvenDensity density = density_of(slab, ground);
  double whole = 0;
  for (const SmallPolygon& part : parts) whole += integral(part, density);
  const std::size_t first = out.size();
  for (const SmallPolygon& part : parts) append_cell_parts(part, density, cell_m, out);
  for (std::size_t i = first; i < out.size(); ++i) out[i].amount *= slab.amount / whole;
}

}  // namespace tramline::coverage
