#include "tramline/coverage/dose/dose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tramline/coverage/dose/dose_figures.h"
#include "tramline/coverage/dose/laid_cells.h"
#include "tramline/coverage/dose/lay_slab.h"
#include "tramline/coverage/dose/quad_amount.h"
#include "tramline/coverage/dose/region_in_cells.h"
#include "tramline/coverage/dose/wind_drift.h"
#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/thread_limit.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

/// Lays the steps of a drive one after the other.
class Layer {
 public:
  Layer(const DoseSettings& settings, double width_m)
      : settings_(settings), half_width_m_(0.5 * width_m), cells_(settings.cell_m) {
    if (!settings.pattern.empty())
      pattern_ = TransversePattern(settings.pattern, width_m, settings.pattern_place);
  }

  void add(const WorkedStep& step) {
    for (std::size_t i = 0; i < step.quads.size(); ++i) {
      const QuadOrigin& origin = step.origins[i];
      const QuadAmount amount = amount_of(step, origin, settings_.rates);
      if (std::isnan(amount.per_m)) {
        ++without_rate_;
        continue;
      }
      if (!(amount.per_m > 0)) continue;
      slabs_.clear();
      append_slabs(step.quads[i], origin.section, amount.per_m, pattern_, half_width_m_, settings_.cell_m,
                   slabs_);
      for (const Slab& slab : slabs_) {
        parts_.clear();
        append_laid(slab, settings_.cell_m, parts_);
        cells_.add(parts_);
        (amount.logged ? logged_ : nominal_) += slab.amount;
      }
    }
  }

  const LaidCells& cells() const { return cells_; }
  double logged() const { return logged_; }
  double nominal() const { return nominal_; }
  std::size_t without_rate() const { return without_rate_; }

 private:
  const DoseSettings& settings_;
  double half_width_m_;
  TransversePattern pattern_;
  LaidCells cells_;
  std::vector<Slab> slabs_;
  std::vector<CellPart> parts_;
  double logged_ = 0, nominal_ = 0;
  std::size_t without_rate_ = 0;
};

void require_rates(const WorkLog& log, const RateSettings& rates) {
  const bool logged = rates.use_logged && std::any_of(log.fixes.begin(), log.fixes.end(), [](const Fix& fix) {
                        return !std::isnan(fix.rate_per_ha);
                      });
  if (!logged && std::isnan(rates.nominal_per_ha))
    throw bad_input(
        rates.use_logged
            ? fmt::format("{} does not say how much was applied: give --nominal-rate", log.name)
            : fmt::format("{}: no logged rate may be used (--no-logged-rate): give --nominal-rate",
                          log.name));
  if (!std::isnan(rates.nominal_speed_mps) && log.clock == Clock::kNone)
    throw bad_input(
        fmt::format("{} has no times, so its speed is unknown: leave out --nominal-speed", log.name));
}

/// Throws before the work starts. The map takes in the field and every position that may have been worked.
void require_cells_for(const WorkLog& log, const Region& field, double cell_m) {
  const bool logged = says_work(log);
  Box box = field.empty() ? Box{} : bounds(field);
  for (const Fix& fix : log.fixes)
    if (logged ? fix.work == WorkState::kOn : fix.work != WorkState::kOff) box.extend(fix.position);
  if (!box.empty()) require_few_cells(box.width(), box.height(), cell_m);
}

/// Grid, what the wind does, and figures. `map`: all but these.
void finish(DoseMap& map, CellContents& cells, const DoseSettings& settings) {
  if (map.drift) {
    cells.drifted = drifted(cells.laid, map.grid, *map.drift);
    for (double& amount : cells.laid) amount *= 1 - map.drift->share;
  }
  map.figures = figures_of(cells, map.grid, settings.rates.nominal_per_ha);
  const std::vector<double>& ground = cells.field_m2.empty() ? cells.covered_m2 : cells.field_m2;
  for (const double m2 : ground) map.ground.push_back(static_cast<float>(m2 / map.grid.cell_area_m2()));
  map.on_ground = amounts_on_ground(cells, map.grid);
  map.amount = std::move(cells.laid);
  for (std::size_t i = 0; i < cells.drifted.size(); ++i) map.amount[i] += cells.drifted[i];
}

Box reach_of(const DoseMap& map) { return map.drift ? reach(*map.drift, map.grid.cell_m) : Box{0, 0, 0, 0}; }

std::optional<DoseDrift> drift_of(const std::optional<WindSettings>& wind) {
  return wind ? std::optional(drift_of(*wind)) : std::nullopt;
}

Box box_of(const Region& region) { return region.empty() ? Box{} : bounds(region); }

void add_ground(CellContents& cells, const CellGrid& grid, const Region& field, const Coverage& coverage) {
  cells.covered_m2 = area_in_cells(coverage.covered, grid);
  if (field.empty()) return;
  cells.field_m2 = area_in_cells(field, grid);
  cells.missed_m2 = area_in_cells(coverage.missed, grid);
  const std::vector<double> not_recorded_m2 = area_in_cells(coverage.not_recorded, grid);
  for (std::size_t i = 0; i < not_recorded_m2.size(); ++i) cells.missed_m2[i] += not_recorded_m2[i];
}

/// How often ground of the class 3 was worked, on average.
double often(const CoverageAreas& areas) {
  const auto& times = areas.worked_times_m2;
  return times[3] > 0 ? std::max(3.0, (areas.gross_m2 - times[1] - 2 * times[2]) / times[3]) : 3;
}

void require_counted(const Coverage& coverage, const RateSettings& rates) {
  if (std::isnan(rates.nominal_per_ha))
    throw bad_input("a coverage file does not say how much was applied: give --nominal-rate");
  constexpr double kDrawn = 1e-6;
  for (std::size_t times = 1; times < coverage.worked_times.size(); ++times) {
    const double counted_m2 = coverage.areas.worked_times_m2[times];
    if (!(std::abs(area(coverage.worked_times[times]) - counted_m2) <= kDrawn * coverage.areas.gross_m2))
      throw bad_input(
          "the coverage file does not show how often land was worked: write it with tramline evaluate -o and "
          "without --engine mesh");
  }
}

}  // namespace

DoseMap dose(WorkLog log, const Region& field, const DoseSettings& settings, const FixProgress& progress) {
  if (!log.shapes.empty())
    throw bad_input(
        fmt::format("{} has polygons, which do not say how they were driven; evaluate them with -o and give "
                    "the coverage file with --nominal-rate",
                    log.name));
  require_rates(log, settings.rates);
  const ThreadLimit limit(settings.evaluate.threads);
  EvaluateSettings evaluation = settings.evaluate;
  evaluation.engine = EngineKind::kExact;
  evaluation.shapes = false;
  evaluation.covered = true;
  DoseMap out;
  out.log = log.name;
  log = log_without_faults(std::move(log));  // widths as evaluate() will have them
  require_cells_for(log, field, settings.cell_m);
  Layer layer(settings, working_width_m(log, evaluation.drive));
  const Coverage coverage =
      evaluate(std::move(log), field, evaluation, progress, [&](const WorkedStep& step) { layer.add(step); });
  out.warnings = coverage.warnings;
  if (layer.without_rate() > 0)
    out.warnings.push_back(
        fmt::format("{} steps have no logged rate: nothing is applied there without --nominal-rate",
                    layer.without_rate()));
  out.width_m = coverage.width_m;
  out.covered_m2 = coverage.areas.covered_m2;
  out.logged_amount = layer.logged();
  out.nominal_amount = layer.nominal();
  out.drift = drift_of(settings.wind);
  out.grid.cell_m = settings.cell_m;
  // Covered ground that got nothing is ground too.
  const Box ground = box_of(field.empty() ? coverage.covered : field);
  out.grid = layer.cells().grid(ground, reach_of(out));
  CellContents cells;
  cells.laid = layer.cells().amounts(out.grid);
  add_ground(cells, out.grid, field, coverage);
  finish(out, cells, settings);
  return out;
}

DoseMap dose(const Coverage& coverage, const DoseSettings& settings) {
  require_counted(coverage, settings.rates);
  const ThreadLimit limit(settings.evaluate.threads);
  DoseMap out;
  out.log = coverage.log;
  out.field_id = coverage.field_id;
  out.field = coverage.field;
  out.frame = coverage.frame;
  out.width_m = coverage.width_m;
  out.covered_m2 = coverage.areas.covered_m2;
  out.drift = drift_of(settings.wind);
  Box box = box_of(coverage.field);
  if (!coverage.covered.empty()) box.extend(bounds(coverage.covered));
  out.grid.cell_m = settings.cell_m;
  out.grid = LaidCells(settings.cell_m).grid(box, reach_of(out));
  CellContents cells;
  cells.laid.assign(out.grid.size(), 0.0);
  const double each = settings.rates.nominal_per_ha / 1e4;
  for (std::size_t times = 1; times < coverage.worked_times.size(); ++times) {
    const double layers = times < kMostCounted ? static_cast<double>(times) : often(coverage.areas);
    const std::vector<double> m2 = area_in_cells(coverage.worked_times[times], out.grid);
    for (std::size_t i = 0; i < m2.size(); ++i) cells.laid[i] += layers * each * m2[i];
  }
  for (const double amount : cells.laid) out.nominal_amount += amount;
  add_ground(cells, out.grid, coverage.field, coverage);
  finish(out, cells, settings);
  return out;
}

}  // namespace tramline::coverage
