#include "tramline/planner/prove/strip_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tramline {

double SweepScale::reach_m() const {
  // Half a step to the nearest offset, the turn, and from the middle of a sample to its corners.
  constexpr double kRounding_m = 1e-6;
  return step_m() * (0.5 + std::numbers::sqrt2 / 2) + radius_m * half_angle + kRounding_m;
}

void StripSweep::lay(double angle) {
  up_ = {std::sin(angle), std::cos(angle)};
  right_ = {up_.y, -up_.x};
  const Box land = ground_.box();
  Box turned;
  for (const Point corner : {Point{land.min_x, land.min_y}, Point{land.max_x, land.min_y},
                             Point{land.max_x, land.max_y}, Point{land.min_x, land.max_y}})
    turned.extend(Point{dot(corner - pivot_, right_), dot(corner - pivot_, up_)});
  const double step_m = scale_.step_m();
  first_line_ = static_cast<int>(std::floor(turned.min_x / step_m));
  lines_ = static_cast<int>(std::ceil(turned.max_x / step_m)) - first_line_;
  first_row_ = static_cast<int>(std::floor(turned.min_y / step_m));
  rows_ = static_cast<int>(std::ceil(turned.max_y / step_m)) - first_row_;
  const auto count = static_cast<std::size_t>(lines_) * static_cast<std::size_t>(rows_);
  sets_.resize(count);
  samples_.resize(count);
  std::size_t at = 0;
  for (int line = 0; line < lines_; ++line)
    for (int row = 0; row < rows_; ++row, ++at) {
      sets_[at] = ground_.set_at(pivot_ + (first_line_ + line + 0.5) * step_m * right_ +
                                 (first_row_ + row + 0.5) * step_m * up_);
      samples_[at] = worth_.worth[static_cast<std::size_t>(sets_[at])];
    }
  sums_.assign(static_cast<std::size_t>(rows_), 0);
  // Swaths begin up to their width left of the land.
  best_.assign(static_cast<std::size_t>(lines_ + scale_.lines - 1), {});
  for (int offset = 0; offset < offsets(); ++offset) look(offset);
}

std::int32_t StripSweep::set_at(int line, int row) const {
  if (line < 0 || line >= lines_) return 0;
  return sets_[static_cast<std::size_t>(line) * static_cast<std::size_t>(rows_) +
               static_cast<std::size_t>(row)];
}

void StripSweep::look(int offset) {
  const double pixel_m2 = scale_.step_m() * scale_.step_m();
  if (offset % scale_.lines == 0) {
    // Afresh now and then, so that rounding does not add up.
    std::fill(sums_.begin(), sums_.end(), 0);
    for (int i = 0; i < scale_.lines; ++i) add_line(offset - i, 1);
  } else {
    add_line(offset, 1);
    add_line(offset - scale_.lines, -1);
  }
  // Of all stretches of rows the one with the largest sum.
  Best& best = best_[static_cast<std::size_t>(offset)];
  best = {};
  double sum = 0;
  int from = 0;
  for (int row = 0; row < rows_; ++row) {
    if (sum <= 0) {
      sum = 0;
      from = row;
    }
    sum += sums_[static_cast<std::size_t>(row)] * pixel_m2;
    if (sum > best.worth) best = {sum, from, row + 1};
  }
}

void StripSweep::add_line(int line, double sign) {
  if (line < 0 || line >= lines_) {
    for (double& sum : sums_) sum += sign * worth_.worth[0];
    return;
  }
  const double* worth = &samples_[static_cast<std::size_t>(line) * sums_.size()];
  for (std::size_t row = 0; row < sums_.size(); ++row) sums_[row] += sign * worth[row];
}

double StripSweep::most() const {
  double out = 0;
  for (const Best& best : best_) out = std::max(out, best.worth);
  return out;
}

PieceWorth StripSweep::piece(int offset) const {
  const Best& best = best_[static_cast<std::size_t>(offset)];
  PieceWorth out;
  out.worth = best.worth;
  std::map<int, double> areas;
  const double pixel_m2 = scale_.step_m() * scale_.step_m();
  for (int row = best.from; row < best.to; ++row)
    for (int i = 0; i < scale_.lines; ++i)
      areas[worth_.label[static_cast<std::size_t>(set_at(offset - scale_.lines + 1 + i, row))]] += pixel_m2;
  for (const auto& [label, area_m2] : areas) {
    if (label == GroundLabels::kOutside) out.outside_m2 = area_m2;
    if (label >= 0) out.area_m2.emplace_back(label, area_m2);
  }
  return out;
}

}  // namespace tramline
