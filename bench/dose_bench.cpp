// How fast a drive is laid on cells: how much was applied where.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "tramline/coverage/dose/dose.h"

namespace tramline::bench {
namespace {

constexpr double kHertz = 5, kSpeed_mps = 3, kPass_m = 300, kWidth_m = 24;
constexpr std::size_t kInTurn = 25;  ///< fixes, the work off

/// Up and down beside one another, half a metre worked twice, the rate about 200 l/ha; round the ends without
/// work. 10 000 fixes are 55 minutes.
WorkLog spraying(std::size_t fixes) {
  WorkLog log;
  log.name = "made";
  log.clock = Clock::kUtc;
  log.positions = Positions::kLocal;
  log.rate_unit = AmountUnit::kLitres;
  const double step_m = kSpeed_mps / kHertz;
  const auto in_pass = static_cast<std::size_t>(kPass_m / step_m);
  for (std::size_t i = 0; i < fixes; ++i) {
    const std::size_t pass = i / (in_pass + kInTurn), place = i % (in_pass + kInTurn);
    const bool up = pass % 2 == 0, works = place < in_pass;
    const double x = static_cast<double>(pass) * (kWidth_m - 0.5);
    const double along = static_cast<double>(place) * step_m;
    const double round = std::numbers::pi * static_cast<double>(place - (works ? place : in_pass)) / kInTurn;
    const double radius = 0.5 * (kWidth_m - 0.5);
    const Point at = works ? Point{x, up ? along : kPass_m - along}
                           : Point{x + radius * (1 - std::cos(round)),
                                   (up ? kPass_m : 0) + (up ? radius : -radius) * std::sin(round)};
    Fix fix;
    fix.time_s = static_cast<double>(i) / kHertz;
    fix.position = at;
    fix.work = works ? WorkState::kOn : WorkState::kOff;
    fix.rate_per_ha = 200 + 10 * std::sin(0.01 * static_cast<double>(i));
    log.fixes.push_back(fix);
  }
  return log;
}

void run(benchmark::State& state, const coverage::DoseSettings& settings) {
  const auto fixes = static_cast<std::size_t>(state.range(0));
  const WorkLog log = spraying(fixes);
  double laid = 0;
  for (auto _ : state) {
    WorkLog copy = log;
    const DoseMap map = coverage::dose(std::move(copy), {}, settings, {});
    laid += map.figures.total;
  }
  benchmark::DoNotOptimize(laid);
  state.counters["fixes/s"] = benchmark::Counter(
      static_cast<double>(fixes) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

coverage::DoseSettings on_one_thread() {
  coverage::DoseSettings out;
  out.evaluate.drive.width_m = kWidth_m;
  out.evaluate.threads = 1;
  return out;
}

void even(benchmark::State& state) { run(state, on_one_thread()); }
BENCHMARK(even)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// Less at both ends of the boom, in five stretches.
void with_pattern(benchmark::State& state) {
  coverage::DoseSettings settings = on_one_thread();
  settings.pattern = {{-12.5, 0}, {-11.5, 1}, {-4, 1.02}, {4, 0.98}, {11.5, 1}, {12.5, 0}};
  settings.pattern_place = "the pattern";
  run(state, settings);
}
BENCHMARK(with_pattern)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// 4 m/s from the west spread the cells.
void with_wind(benchmark::State& state) {
  coverage::DoseSettings settings = on_one_thread();
  settings.wind = coverage::WindSettings{};
  settings.wind->speed_mps = 4;
  run(state, settings);
}
BENCHMARK(with_wind)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
