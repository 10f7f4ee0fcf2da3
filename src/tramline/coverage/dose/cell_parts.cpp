#include "tramline/coverage/dose/cell_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline::coverage {
namespace {

struct Range {
  double low = 0;
  double high = 0;
};

Range range(const SmallPolygon& polygon, double Point::*axis) {
  Range out{polygon.corners[0].*axis, polygon.corners[0].*axis};
  for (std::size_t i = 1; i < polygon.size; ++i) {
    out.low = std::min(out.low, polygon.corners[i].*axis);
    out.high = std::max(out.high, polygon.corners[i].*axis);
  }
  return out;
}

/// Both sides of a line along the other axis; corners on it belong to both.
void split(const SmallPolygon& polygon, double Point::*axis, double at, SmallPolygon& low,
           SmallPolygon& high) {
  low.size = high.size = 0;
  Point previous = polygon.corners[polygon.size - 1];
  double before = previous.*axis - at;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Point current = polygon.corners[i];
    const double now = current.*axis - at;
    if ((before < 0 && now > 0) || (before > 0 && now < 0)) {
      Point cut = previous + before / (before - now) * (current - previous);
      cut.*axis = at;
      low.add(cut);
      high.add(cut);
    }
    if (now <= 0) low.add(current);
    if (now >= 0) high.add(current);
    previous = current;
    before = now;
  }
}

/// Hands over the slices between the lines of the grid across an axis. A slice that ends on a line belongs to
/// the cell before it.
template <class Take>
void slices(SmallPolygon rest, double Point::*axis, double cell_m, Take take) {
  const Range reach = range(rest, axis);
  auto cell = static_cast<std::int64_t>(std::floor(reach.low / cell_m));
  const auto last = std::max(cell, static_cast<std::int64_t>(std::ceil(reach.high / cell_m)) - 1);
  SmallPolygon low, high;
  for (; cell < last && rest.size >= 3; ++cell) {
    split(rest, axis, static_cast<double>(cell + 1) * cell_m, low, high);
    if (low.size >= 3) take(low, cell);
    rest = high;
  }
  if (rest.size >= 3) take(rest, last);
}

}  // namespace

double integral(const SmallPolygon& polygon, const EvenDensity& density) {
  const Point a = polygon.corners[0];
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size; ++i) {
    const Point b = polygon.corners[i - 1], c = polygon.corners[i];
    const Point middle = a + (1.0 / 3) * ((b - a) + (c - a));
    sum += 0.5 * cross(b - a, c - a) * density(middle);
  }
  return sum;
}

void append_cell_parts(const SmallPolygon& polygon, const EvenDensity& density, double cell_m,
                       std::vector<CellPart>& out) {
  assert(polygon.size <= 8);
  slices(polygon, &Point::y, cell_m, [&](const SmallPolygon& in_row, std::int64_t row) {
    slices(in_row, &Point::x, cell_m, [&](const SmallPolygon& in_cell, std::int64_t column) {
      out.push_back({column, row, integral(in_cell, density)});
    });
  });
}

}  // namespace tramline::coverage
