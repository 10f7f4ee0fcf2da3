#include "report/dose_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/report_parts.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

constexpr int kBarLength = 40;
/// Where less of the ground is counted cell by cell, that is said.
constexpr double kMostlyCounted = 0.95;

ordered_json histogram_json(const DoseFigures& figures) {
  ordered_json out = ordered_json::array();
  for (const DoseBin& bin : figures.histogram)
    out.push_back({{"from", bin.from_per_ha}, {"to", number_json(bin.to_per_ha)}, {"area_m2", bin.area_m2}});
  return out;
}

ordered_json drift_json(const DoseDrift& drift) {
  return {{"wind_mps", drift.wind_mps},
          {"wind_from_deg", drift.wind_from.degrees()},
          {"shift_m", drift.shift_m},
          {"spread_m", drift.spread_m}};
}

double off_ground(const DoseFigures& figures) { return figures.total - figures.on_ground; }

std::string share(double part, double whole) {
  return whole > 0 ? fmt::format(" ({:.2f} %)", 100 * part / whole) : "";
}

std::string ground_rows(const DoseMap& map) {
  std::string out;
  if (!map.field.empty())
    out += fmt::format("field        {}, {:.4f} ha\n", map.field_id, area(map.field) / 1e4);
  if (!map.log.empty()) out += fmt::format("log          {}\n", map.log);
  out += fmt::format("covered      {:.1f} m²", map.covered_m2);
  return out + (std::isfinite(map.width_m) ? fmt::format(", {:g} m wide\n", map.width_m) : "\n");
}

std::string amount_rows(const DoseMap& map) {
  const DoseFigures& figures = map.figures;
  const std::string& unit = map.unit;
  std::string out = fmt::format("applied      {:.2f} {}{}\n", figures.total, unit,
                                map.logged_amount > 0 && map.nominal_amount > 0
                                    ? fmt::format(", {:.2f} of it by logged rates", map.logged_amount)
                                : map.logged_amount > 0 ? ", by logged rates"
                                                        : ", by the nominal rate");
  out += fmt::format("  on ground  {:.2f} {}{} of {}\n", figures.on_ground, unit,
                     share(figures.on_ground, figures.total),
                     map.field.empty() ? "covered ground" : "the field");
  if (map.drift)
    out += fmt::format("wind         {:.2f} {}{} drifts {:.2f} m downwind, spread {:.2f} m\n",
                       map.drift->share * figures.total, unit, share(map.drift->share, 1), map.drift->shift_m,
                       map.drift->spread_m);
  out += fmt::format("rate         {:.2f} {}/ha on average, CV {:.2f} %, from {:.2f} to {:.2f}\n",
                     figures.mean_per_ha, unit, 100 * figures.cv, figures.least_per_ha, figures.most_per_ha);
  out += fmt::format("within 10 %  {:.2f} % of the ground, of {:.2f} {}/ha\n", 100 * figures.share_within_10,
                     figures.reference_per_ha, unit);
  if (figures.counted_m2 < kMostlyCounted * figures.ground_m2)
    out += fmt::format(
        "cells        of which half or more is ground hold {:.1f} of {:.1f} m²: CV, within 10 % and what "
        "follows are of these; a smaller --cell counts more\n",
        figures.counted_m2, figures.ground_m2);
  out +=
      fmt::format("map          {} x {} cells of {:g} m\n", map.grid.columns, map.grid.rows, map.grid.cell_m);
  return out;
}

std::string histogram_rows(const DoseMap& map) {
  const DoseFigures& figures = map.figures;
  double most_m2 = 0;
  for (const DoseBin& bin : figures.histogram) most_m2 = std::max(most_m2, bin.area_m2);
  if (!(most_m2 > 0)) return "";
  std::string out = fmt::format("{:>22}  {:>8}\n", map.unit + "/ha", "ground");
  for (const DoseBin& bin : figures.histogram) {
    if (!(bin.area_m2 > 0)) continue;
    const std::string range = std::isfinite(bin.to_per_ha)
                                  ? fmt::format("{:.1f} to {:.1f}", bin.from_per_ha, bin.to_per_ha)
                                  : fmt::format("{:.1f} and more", bin.from_per_ha);
    const int length = static_cast<int>(std::lround(kBarLength * bin.area_m2 / most_m2));
    out += fmt::format("{:>22}  {:>6.2f} % {}\n", range, 100 * bin.area_m2 / figures.counted_m2,
                       std::string(static_cast<std::size_t>(length), '#'));
  }
  return out;
}

}  // namespace

ordered_json dose_json(const DoseMap& map, double seconds) {
  const DoseFigures& figures = map.figures;
  ordered_json out;
  out["field_id"] = map.field.empty() ? ordered_json() : ordered_json(map.field_id);
  out["log"] = map.log.empty() ? ordered_json() : ordered_json(map.log);
  out["unit"] = map.unit;
  out["width_m"] = number_json(map.width_m);
  out["total_amount"] = figures.total;
  out["logged_amount"] = map.logged_amount;
  out["nominal_amount"] = map.nominal_amount;
  out["ground_amount"] = figures.on_ground;
  out["off_ground_amount"] = off_ground(figures);
  out["applied_area_m2"] = map.covered_m2;
  out["ground_m2"] = figures.ground_m2;
  out["counted_m2"] = figures.counted_m2;
  out["reference"] = figures.reference_per_ha;
  out["mean"] = figures.mean_per_ha;
  out["cv"] = figures.cv;
  out["share_within_10"] = figures.share_within_10;
  out["min"] = figures.least_per_ha;
  out["max"] = figures.most_per_ha;
  out["histogram"] = histogram_json(figures);
  out["cells"] = map.grid.size();
  out["columns"] = map.grid.columns;
  out["rows"] = map.grid.rows;
  out["cell_m"] = map.grid.cell_m;
  out["drifted_share"] = map.drift ? map.drift->share : 0;
  if (map.drift) out["wind"] = drift_json(*map.drift);
  out["warnings"] = map.warnings;
  out["seconds"] = seconds;
  return out;
}

std::string dose_table(const DoseMap& map, double seconds) {
  std::string out = ground_rows(map) + amount_rows(map) + histogram_rows(map);
  out += fmt::format("time         {:.3f} s\n", seconds);
  out += note_rows(map.warnings);
  return out;
}

}  // namespace tramline::app
