#include "tramline/coverage/dose/region_in_cells.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline::coverage {
namespace {

/// By Green's theorem: an edge that goes up by dy has all cells of its row to the left of it below its part
/// of the row, one that goes down takes them away. Each part of an edge is noted where it lies, and the sum
/// from the right end of the row makes areas of it.
class EdgeNotes {
 public:
  EdgeNotes(const CellGrid& grid, std::vector<double>& notes) : grid_(grid), notes_(notes) {}

  /// In cells of the grid.
  void add_edge(Point a, Point b) {
    if (a.y == b.y) return;
    const double sign = a.y < b.y ? 1 : -1;
    if (sign < 0) std::swap(a, b);
    const double low = std::max(a.y, 0.0), high = std::min(b.y, static_cast<double>(grid_.rows));
    if (!(low < high)) return;
    const auto at = [&](double y) { return y >= b.y ? b.x : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y); };
    double y = low, x = low > a.y ? at(low) : a.x;
    for (int row = static_cast<int>(low); y < high; ++row) {
      const double next_y = std::min(high, row + 1.0);
      const double next_x = at(next_y);
      if (next_y > y) add_in_row(row, x, next_x, sign * (next_y - y));
      y = next_y;
      x = next_x;
    }
  }

 private:
  /// From x to next_x over dy, in one row.
  void add_in_row(int row, double x, double next_x, double dy) {
    const double from = std::min(x, next_x), to = std::max(x, next_x);
    if (to - from < 1e-12 || std::floor(from) == std::floor(to)) return note(row, 0.5 * (from + to), dy);
    const double dy_by_x = dy / (to - from);
    for (double left = from; left < to;) {
      const double right = std::min(to, std::floor(left) + 1);
      note(row, 0.5 * (left + right), dy_by_x * (right - left));
      left = right;
    }
  }

  void note(int row, double x, double dy) {
    if (x <= 0) return;
    const double last = grid_.columns - 1;
    const double column = std::min(std::floor(x), last);
    const double within = std::min(x - column, 1.0);
    const std::size_t i = grid_.index(static_cast<int>(column), row);
    notes_[i] += dy * within;
    if (column > 0) notes_[i - 1] += dy * (1 - within);
  }

  const CellGrid& grid_;
  std::vector<double>& notes_;
};

}  // namespace

std::vector<double> area_in_cells(const Region& region, const CellGrid& grid) {
  assert(std::all_of(region.begin(), region.end(),
                     [](const Polygon& part) { return signed_area(part.outer) >= 0; }));
  constexpr double kNone = 1e-9;
  std::vector<double> out(grid.size(), 0.0);
  EdgeNotes notes(grid, out);
  const auto in_cells = [&](Point p) { return (1 / grid.cell_m) * (p - grid.low); };
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      notes.add_edge(in_cells(ring[i]), in_cells(ring[(i + 1) % ring.size()]));
  };
  for (const Polygon& polygon : region) {
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
  }
  for (int row = 0; row < grid.rows; ++row) {
    double sum = 0;
    for (int column = grid.columns - 1; column >= 0; --column) {
      double& cell = out[grid.index(column, row)];
      sum += cell;
      cell = sum < kNone ? 0 : std::min(sum, 1.0) * grid.cell_area_m2();
    }
  }
  return out;
}

}  // namespace tramline::coverage
