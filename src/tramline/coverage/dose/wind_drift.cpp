#include "tramline/coverage/dose/wind_drift.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline::coverage {
namespace {

constexpr double kFurthest = 5;  // standard deviations

/// Shares of a cell's amount by how many cells further they land: first, first + 1, …
struct Kernel {
  int first = 0;
  std::vector<double> shares;
};

/// The integral of the normal distribution function: what lands beyond, of amounts even over a half line.
double ramp(double x, double spread) {
  if (!(spread > 0)) return std::max(0.0, x);
  const double z = x / spread;
  return x * 0.5 * std::erfc(-z / std::numbers::sqrt2) +
         spread * std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
}

/// In cells.
Kernel kernel_of(double shift, double spread) {
  Kernel out;
  out.first = static_cast<int>(std::floor(shift - kFurthest * spread)) - 1;
  const int last = static_cast<int>(std::ceil(shift + kFurthest * spread)) + 1;
  double sum = 0;
  for (int i = out.first; i <= last; ++i) {
    const double x = i - shift;
    const double share = std::max(0.0, ramp(x + 1, spread) - 2 * ramp(x, spread) + ramp(x - 1, spread));
    out.shares.push_back(share);
    sum += share;
  }
  for (double& share : out.shares) share /= sum;
  return out;
}

std::vector<double> along_rows(const std::vector<double>& from, const CellGrid& grid, const Kernel& kernel) {
  std::vector<double> out(from.size(), 0.0);
  tbb::parallel_for(0, grid.rows, [&](int row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double amount = from[grid.index(column, row)];
      if (amount == 0) continue;
      for (std::size_t i = 0; i < kernel.shares.size(); ++i) {
        const int to = column + kernel.first + static_cast<int>(i);
        if (to >= 0 && to < grid.columns) out[grid.index(to, row)] += kernel.shares[i] * amount;
      }
    }
  });
  return out;
}

std::vector<double> along_columns(const std::vector<double>& from, const CellGrid& grid,
                                  const Kernel& kernel) {
  std::vector<double> out(from.size(), 0.0);
  tbb::parallel_for(0, grid.rows, [&](int row) {
    for (std::size_t i = 0; i < kernel.shares.size(); ++i) {
      const int source = row - kernel.first - static_cast<int>(i);
      if (source < 0 || source >= grid.rows) continue;
      for (int column = 0; column < grid.columns; ++column)
        out[grid.index(column, row)] += kernel.shares[i] * from[grid.index(column, source)];
    }
  });
  return out;
}

}  // namespace

DoseDrift drift_of(const WindSettings& wind) {
  const double shift_m = wind.speed_mps * wind.height_m / wind.fall_mps;
  return {wind.speed_mps, wind.from, wind.share, shift_m, wind.spread * shift_m};
}

Box reach(const DoseDrift& drift, double cell_m) {
  const Point shift = -drift.shift_m * drift.wind_from.unit();
  return Box{shift.x, shift.y, shift.x, shift.y}.grown(kFurthest * drift.spread_m + 3 * cell_m);
}

std::vector<double> drifted(const std::vector<double>& laid, const CellGrid& grid, const DoseDrift& drift) {
  const Point shift = (-drift.shift_m / grid.cell_m) * drift.wind_from.unit();
  const double spread = drift.spread_m / grid.cell_m;
  std::vector<double> out =
      along_columns(along_rows(laid, grid, kernel_of(shift.x, spread)), grid, kernel_of(shift.y, spread));
  for (double& amount : out) amount *= drift.share;
  return out;
}

}  // namespace tramline::coverage
