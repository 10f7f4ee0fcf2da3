#include "tramline/coverage/dose/dose_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/coverage/dose/quad_amount.h"

namespace tramline::coverage {
namespace {

constexpr double kNear = 0.1;  // of the reference: within, and the width of a bin
constexpr int kBins = 25;      // before the last
constexpr double kRounding = 1e-9;

/// One cell's ground and what lies on it.
struct OnGround {
  double ground_m2 = 0;
  double amount = 0;
};

OnGround on_ground(const CellContents& cells, const CellGrid& grid, std::size_t i) {
  const bool field = !cells.field_m2.empty();
  OnGround out;
  out.ground_m2 = field ? cells.field_m2[i] : cells.covered_m2[i];
  if (!(out.ground_m2 > 0)) return out;
  const double covered_m2 = cells.covered_m2[i];
  const double worked_m2 = field ? std::max(0.0, cells.field_m2[i] - cells.missed_m2[i]) : covered_m2;
  if (covered_m2 > 0) out.amount = cells.laid[i] * std::min(1.0, worked_m2 / covered_m2);
  if (!cells.drifted.empty()) out.amount += cells.drifted[i] * out.ground_m2 / grid.cell_area_m2();
  return out;
}

/// Of the cell that has most: cells may be larger than the field.
double most_ground(const CellContents& cells, const CellGrid& grid) {
  double most_m2 = 0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    most_m2 = std::max(most_m2, on_ground(cells, grid, i).ground_m2);
  return most_m2;
}

std::vector<DoseBin> bins(double reference) {
  std::vector<DoseBin> out;
  for (int k = 0; k <= kBins; ++k)
    out.push_back({std::max(0.0, (k - 0.5) * kNear * reference),
                   k < kBins ? (k + 0.5) * kNear * reference : std::numeric_limits<double>::infinity(), 0});
  return out;
}

std::size_t bin_of(double rate, double reference) {
  const double bin = reference > 0 ? std::floor(rate / (kNear * reference) + 0.5) : 0;
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(kBins)));
}

}  // namespace

DoseFigures figures_of(const CellContents& cells, const CellGrid& grid, double nominal_per_ha) {
  DoseFigures out;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    out.total += cells.laid[i] + (cells.drifted.empty() ? 0 : cells.drifted[i]);
    const OnGround cell = on_ground(cells, grid, i);
    out.on_ground += cell.amount;
    out.ground_m2 += cell.ground_m2;
  }
  if (!(out.ground_m2 > 0)) return out;
  out.mean_per_ha = out.on_ground / out.ground_m2 * kHectare_m2;
  out.reference_per_ha = std::isnan(nominal_per_ha) ? out.mean_per_ha : nominal_per_ha;
  out.histogram = bins(out.reference_per_ha);
  out.least_per_ha = std::numeric_limits<double>::infinity();
  double sum = 0, squares = 0, near_m2 = 0;
  const double least_m2 = 0.5 * std::min(grid.cell_area_m2(), most_ground(cells, grid));
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const OnGround cell = on_ground(cells, grid, i);
    if (!(cell.ground_m2 > 0) || cell.ground_m2 < least_m2) continue;
    const double rate = cell.amount / cell.ground_m2 * kHectare_m2;
    const double off = rate - out.mean_per_ha;
    out.counted_m2 += cell.ground_m2;
    sum += cell.ground_m2 * off;
    squares += cell.ground_m2 * off * off;
    if (std::abs(rate - out.reference_per_ha) <= (kNear + kRounding) * out.reference_per_ha)
      near_m2 += cell.ground_m2;
    out.histogram[bin_of(rate, out.reference_per_ha)].area_m2 += cell.ground_m2;
    out.least_per_ha = std::min(out.least_per_ha, rate);
    out.most_per_ha = std::max(out.most_per_ha, rate);
  }
  const double off_mean = sum / out.counted_m2, counted_mean = out.mean_per_ha + off_mean;
  if (counted_mean > 0)
    out.cv = std::sqrt(std::max(0.0, squares / out.counted_m2 - off_mean * off_mean)) / counted_mean;
  out.share_within_10 = near_m2 / out.counted_m2;
  return out;
}

std::vector<float> amounts_on_ground(const CellContents& cells, const CellGrid& grid) {
  std::vector<float> out(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) out[i] = static_cast<float>(on_ground(cells, grid, i).amount);
  return out;
}

}  // namespace tramline::coverage
