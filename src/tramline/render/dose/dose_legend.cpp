#include "tramline/render/dose/dose_legend.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace tramline::render {
namespace {

constexpr std::size_t kHistogramRows = 8;

void add(LegendBlock& block, const char* text, std::string value) {
  block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
}

std::string amount_text(double amount, const std::string& unit) {
  return fmt::format("{:.{}f} {}", std::abs(amount) < 5e-4 ? 0.0 : amount, std::abs(amount) < 10 ? 2 : 0,
                     unit);
}

LegendBlock histogram(const DoseMap& map) {
  LegendBlock block{"Amount applied, " + map.unit + "/ha", {}};
  block.rows.resize(kHistogramRows);
  return block;
}

LegendBlock figures(const DoseMap& map) {
  const DoseFigures& figures = map.figures;
  const bool field = !map.field.empty();
  LegendBlock block{field ? "On the field" : "On covered ground", {}};
  add(block, field ? "field" : "covered", area_text(figures.ground_m2));
  if (field) add(block, "covered, beyond it too", area_text(map.covered_m2));
  add(block, "mean", fmt::format("{:.1f} {}/ha", figures.mean_per_ha, map.unit));
  add(block, "coefficient of variation", fmt::format("{:.1f} %", 100 * figures.cv));
  add(block, fmt::format("within 10 % of {:.4g}", figures.reference_per_ha).c_str(),
      fmt::format("{:.1f} %", 100 * figures.share_within_10));
  add(block, "least and most",
      fmt::format("{:.0f} – {:.0f} {}/ha", figures.least_per_ha, figures.most_per_ha, map.unit));
  return block;
}

LegendBlock amounts(const DoseMap& map) {
  const DoseFigures& figures = map.figures;
  LegendBlock block{"Amounts", {}};
  add(block, "applied", amount_text(figures.total, map.unit));
  if (map.logged_amount > 0 && map.nominal_amount > 0)
    add(block, "of it by logged rates", amount_text(map.logged_amount, map.unit));
  add(block, map.field.empty() ? "beyond covered ground" : "beyond the field",
      amount_text(figures.total - figures.on_ground, map.unit));
  add(block, "cells", fmt::format("{:g} m", map.grid.cell_m));
  return block;
}

LegendBlock wind(const DoseDrift& drift) {
  LegendBlock block{"Wind", {}};
  add(block, "speed, from", fmt::format("{:g} m/s, {:.0f}°", drift.wind_mps, drift.wind_from.degrees()));
  add(block, "drifts", fmt::format("{:.1f} %", 100 * drift.share));
  add(block, "downwind, spread", fmt::format("{:.1f} m, {:.1f} m", drift.shift_m, drift.spread_m));
  return block;
}

}  // namespace

std::vector<LegendBlock> legend_of(const DoseMap& map) {
  std::vector<LegendBlock> blocks{histogram(map), figures(map), amounts(map)};
  if (map.drift) blocks.push_back(wind(*map.drift));
  return blocks;
}

}  // namespace tramline::render
