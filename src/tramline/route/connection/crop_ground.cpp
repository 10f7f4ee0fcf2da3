#include "tramline/route/connection/crop_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tramline {
namespace {

/// Cells are no smaller, m: smaller ones would be more than the steps over them.
constexpr double kLeastCell_m = 1;
/// Edges this near to a cell meet it: rounding must not put a point on the wrong side of one.
constexpr double kBesideCell_m = 1e-6;

/// Calls `visit(point)` for the middle of each step along a stretch.
template <class Visit>
void for_each_step(const SteeredStretch& stretch, double steps, const Visit& visit) {
  const double each_m = stretch.length_m / steps;
  if (stretch.clothoid()) {
    for (double step = 0; step < steps; ++step) visit(pose_after(stretch, (step + 0.5) * each_m).at);
    return;
  }
  Point at = pose_after(stretch, 0.5 * each_m).at;
  visit(at);
  if (steps < 2) return;
  // From step to step a chord turns by as much.
  Point on = pose_after(stretch, 1.5 * each_m).at - at;
  const double turn = each_m * stretch.curvature_at_start * (stretch.gear == Gear::kForward ? 1 : -1);
  const double cosine = std::cos(turn), sine = std::sin(turn);
  for (double step = 1; step < steps; ++step) {
    at = at + on;
    visit(at);
    on = {cosine * on.x - sine * on.y, sine * on.x + cosine * on.y};
  }
}

}  // namespace

CropGround::CropGround(const Region& land) : edges_(land) {
  if (edges_.edges().empty()) return;
  bounds_ = edges_.grid().bounds();
  cell_m_ = std::max(kLeastCell_m, std::sqrt(bounds_.width() * bounds_.height() / kMostCropCells));
  columns_ = static_cast<std::size_t>(bounds_.width() / cell_m_) + 1;
  rows_ = static_cast<std::size_t>(bounds_.height() / cell_m_) + 1;
  cells_.assign(columns_ * rows_, Cell::kOff);
  for (const EdgeIndex::Edge& edge : edges_.edges()) mark(edge);
  fill();
}

std::size_t CropGround::column_of(double x) const {
  return static_cast<std::size_t>(
      std::clamp((x - bounds_.min_x) / cell_m_, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t CropGround::row_of(double y) const {
  return static_cast<std::size_t>(
      std::clamp((y - bounds_.min_y) / cell_m_, 0.0, static_cast<double>(rows_ - 1)));
}

/// The cells that an edge meets: in every row those of the part of the edge in it.
void CropGround::mark(const EdgeIndex::Edge& edge) {
  const auto [low, high] =
      edge.from.y < edge.to.y ? std::pair(edge.from, edge.to) : std::pair(edge.to, edge.from);
  const auto x_at = [&, low = low, high = high](double y) {
    if (y <= low.y || high.y == low.y) return low.x;
    return y >= high.y ? high.x : low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
  };
  for (std::size_t row = row_of(low.y - kBesideCell_m); row <= row_of(high.y + kBesideCell_m); ++row) {
    const double bottom = bounds_.min_y + static_cast<double>(row) * cell_m_;
    const double a = x_at(bottom - kBesideCell_m);
    const double b = low.y == high.y ? high.x : x_at(bottom + cell_m_ + kBesideCell_m);
    const std::size_t last = column_of(std::max(a, b) + kBesideCell_m);
    for (std::size_t column = column_of(std::min(a, b) - kBesideCell_m); column <= last; ++column)
      cells_[row * columns_ + column] = Cell::kMeetsEdge;
  }
}

/// Between neighbours that meet no edge there is none.
void CropGround::fill() {
  for (std::size_t row = 0; row < rows_; ++row)
    for (std::size_t column = 0; column < columns_; ++column) {
      Cell& cell = cells_[row * columns_ + column];
      if (cell == Cell::kMeetsEdge) continue;
      const Cell before = column > 0 ? cells_[row * columns_ + column - 1] : Cell::kMeetsEdge;
      const Cell below = row > 0 ? cells_[(row - 1) * columns_ + column] : Cell::kMeetsEdge;
      if (before != Cell::kMeetsEdge || below != Cell::kMeetsEdge) {
        cell = before != Cell::kMeetsEdge ? before : below;
        continue;
      }
      const Point middle{bounds_.min_x + (static_cast<double>(column) + 0.5) * cell_m_,
                         bounds_.min_y + (static_cast<double>(row) + 0.5) * cell_m_};
      cell = edges_.contains(middle) ? Cell::kOn : Cell::kOff;
    }
}

CropGround::Cell CropGround::cell_of(Point p) const {
  if (cells_.empty() || !intersects(bounds_, {p.x, p.y, p.x, p.y})) return Cell::kOff;
  return cells_[row_of(p.y) * columns_ + column_of(p.x)];
}

double CropGround::length_over_m(const SteeredPath& path) const {
  double out_m = 0;
  std::optional<Point> last;
  bool over = false;
  const auto look = [&](Point at) {
    const Cell cell = cell_of(at);
    if (cell != Cell::kMeetsEdge)
      over = cell == Cell::kOn;
    else
      over = last ? over != edges_.lie_between(*last, at) : edges_.contains(at);
    last = at;
    return over;
  };
  for (const SteeredStretch& stretch : path) {
    if (!(stretch.length_m > 0)) continue;
    const double steps = std::ceil(stretch.length_m / kCropStep_m);
    double steps_over = 0;
    for_each_step(stretch, steps, [&](Point at) { steps_over += look(at) ? 1 : 0; });
    out_m += steps_over * stretch.length_m / steps;
  }
  return out_m;
}

}  // namespace tramline
