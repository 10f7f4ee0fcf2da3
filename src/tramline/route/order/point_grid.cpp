#include "tramline/route/order/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/tolerances.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {

PointGrid::PointGrid(const std::vector<Point>& points) : points_(points) {
  for (const Point p : points) box_.extend(p);
  if (points.empty()) box_.extend(Point{});
  const double longer = std::max({box_.width(), box_.height(), kLeastGridOfPlaces_m});
  const double shorter = std::max(std::min(box_.width(), box_.height()), kFlattestGrid_share * longer);
  cell_m_ = std::max(std::sqrt(2 * longer * shorter / static_cast<double>(points.size() + 1)),
                     kFlattestGrid_share * longer);
  columns_ = static_cast<int>(box_.width() / cell_m_) + 1;
  rows_ = static_cast<int>(box_.height() / cell_m_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < points.size(); ++i)
    cells_[place(column_of(points[i]), row_of(points[i]))].push_back(i);
}

int PointGrid::column_of(Point p) const {
  return std::clamp(static_cast<int>(std::floor((p.x - box_.min_x) / cell_m_)), 0, columns_ - 1);
}

int PointGrid::row_of(Point p) const {
  return std::clamp(static_cast<int>(std::floor((p.y - box_.min_y) / cell_m_)), 0, rows_ - 1);
}

std::size_t PointGrid::place(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

void PointGrid::remove(std::size_t index) {
  const Point p = points_[index];
  std::erase(cells_[place(column_of(p), row_of(p))], index);
}

void PointGrid::add_cell(int column, int row, Point p, std::vector<Found>& found) const {
  if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return;
  for (const std::size_t i : cells_[place(column, row)])
    found.push_back({dot(points_[i] - p, points_[i] - p), i});
}

std::vector<std::size_t> PointGrid::nearest(Point p, std::size_t most) const {
  std::vector<Found> found;
  const int column = column_of(p), row = row_of(p);
  const auto before = [](const Found& a, const Found& b) {
    return std::pair(a.reach_m2, a.index) < std::pair(b.reach_m2, b.index);
  };
  for (int ring = 0; ring < std::max(columns_, rows_); ++ring) {
    // Points in this square ring of cells and beyond are at least so far away.
    const double least = std::max(0, ring - 1) * cell_m_;
    if (found.size() >= most && ring > 0) {
      std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most - 1), found.end(),
                       before);
      if (found[most - 1].reach_m2 < least * least) break;
    }
    for (int dx = -ring; dx <= ring; ++dx) {
      const int step = std::abs(dx) == ring ? 1 : std::max(1, 2 * ring);
      for (int dy = -ring; dy <= ring; dy += step) add_cell(column + dx, row + dy, p, found);
    }
  }
  std::sort(found.begin(), found.end(), before);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) out.push_back(found[i].index);
  return out;
}

bool PointGrid::has_within(Point p, double distance_m) const {
  const Point low = p - Point{distance_m, distance_m}, high = p + Point{distance_m, distance_m};
  for (int row = row_of(low); row <= row_of(high); ++row)
    for (int column = column_of(low); column <= column_of(high); ++column)
      for (const std::size_t i : cells_[place(column, row)])
        if (distance(p, points_[i]) <= distance_m) return true;
  return false;
}

}  // namespace tramline::order
