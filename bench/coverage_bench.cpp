// What the exact engine of coverage takes, a fix at a time, areas read after each.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "irregular_route.h"
#include "quantiles.h"
#include "tramline/coverage/engine.h"
#include "tramline/coverage/tiles/tile_coverage.h"

namespace tramline::bench {
namespace {

using coverage::TileCoverage;
using coverage::WorkedStep;

struct Work {
  double width_m = 4;
  double hertz = 10;
  double speed_mps = 2.5;
  double overlap = 0.05;
  std::size_t fixes = 10000;
  int sections = 1;  ///< more than one: each switches at random, once in a second on average
};

/// Short passes, so that ten thousand fixes make many: a first pass overlaps nothing and costs less.
constexpr double kPass_m = 150;

Region field_of(const Work& work) {
  // As wide as the passes need, less a strip at one side.
  const double step_m = work.speed_mps / work.hertz;
  const double passes = std::ceil(static_cast<double>(work.fixes) * step_m / kPass_m);
  const double width_m = std::max(1.0, passes * work.width_m * (1 - work.overlap) - 10);
  return {{{{0, 10}, {width_m, 0}, {width_m + 20, kPass_m - 10}, {-10, kPass_m - 5}}, {}}};
}

/// Up and down beside one another, with noise of a centimetre across and half a degree; the turns are not
/// worked.
std::vector<WorkedStep> boustrophedon(const Work& work) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> across(0, 0.01), heading_noise(0, 0.009);
  std::bernoulli_distribution switches(1 / work.hertz);
  const double step_m = work.speed_mps / work.hertz;
  const auto per_pass = static_cast<std::size_t>(kPass_m / step_m);
  std::vector<bool> on(static_cast<std::size_t>(work.sections), true);
  std::vector<WorkedStep> out;
  Point left, right;
  int run = -1;
  double travel_m = 0;
  for (std::size_t i = 0; i < work.fixes; ++i) {
    const std::size_t pass = i / per_pass, place = i % per_pass;
    const bool up = pass % 2 == 0;
    const double x = static_cast<double>(pass) * work.width_m * (1 - work.overlap) + across(random);
    const double along = static_cast<double>(place) * step_m;
    const double angle = (up ? 0.5 : 1.5) * 3.14159265358979 + heading_noise(random);
    const Point at{x, up ? along : kPass_m - along};
    const Point to_left{-std::sin(angle), std::cos(angle)};
    const Point new_left = at + 0.5 * work.width_m * to_left, new_right = at - 0.5 * work.width_m * to_left;
    if (place == 0) {
      ++run;
      travel_m = 0;
    } else {
      travel_m += step_m;
      WorkedStep step;
      const auto bar = [](Point from, Point to, double share) { return (1 - share) * from + share * to; };
      for (std::size_t s = 0; work.sections > 1 && s < on.size(); ++s)
        if (switches(random)) on[s] = !on[s];
      for (std::size_t s = 0; s < on.size(); ++s) {
        if (!on[s]) continue;
        std::size_t last = s;
        while (last + 1 < on.size() && on[last + 1]) ++last;
        const double from = static_cast<double>(s) / work.sections,
                     to = (static_cast<double>(last) + 1) / work.sections;
        step.quads.push_back({bar(left, right, from), bar(left, right, to), bar(new_left, new_right, to),
                              bar(new_left, new_right, from)});
        s = last;
      }
      step.run = run;
      step.travel_m = travel_m;
      step.reach_m = work.width_m;
      step.fix = i;
      out.push_back(std::move(step));
    }
    left = new_left;
    right = new_right;
  }
  return out;
}

double quads_in(const std::vector<WorkedStep>& steps) {
  double out = 0;
  for (const WorkedStep& step : steps) out += static_cast<double>(step.quads.size());
  return out;
}

double tile_of(const Work& work) {
  return coverage::tile_for(work.width_m, static_cast<std::size_t>(work.sections));
}

void run(benchmark::State& state, const Work& work) {
  const std::vector<WorkedStep> steps = boustrophedon(work);
  const Region field = field_of(work);
  double sum = 0, bytes = 0, cells = 0;
  for (auto _ : state) {
    TileCoverage engine(field, {tile_of(work), true});
    for (const WorkedStep& step : steps) {
      engine.add(step);
      sum += engine.areas().missed_m2 + engine.areas().repeated_m2;
    }
    bytes = static_cast<double>(engine.size().bytes);
    cells = static_cast<double>(engine.size().cells);
  }
  benchmark::DoNotOptimize(sum);
  const auto rounds = static_cast<double>(state.iterations());
  state.counters["quads/s"] = benchmark::Counter(quads_in(steps) * rounds, benchmark::Counter::kIsRate);
  state.counters["bytes/fix"] = bytes / static_cast<double>(work.fixes);
  state.counters["cells/fix"] = cells / static_cast<double>(work.fixes);
}

void coverage_of_4_m(benchmark::State& state) {
  run(state, {4, 10, 2.5, 0.05, static_cast<std::size_t>(state.range(0)), 1});
}
BENCHMARK(coverage_of_4_m)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void coverage_of_24_m(benchmark::State& state) {
  run(state, {24, 10, 2.5, 0.05, static_cast<std::size_t>(state.range(0)), 1});
}
BENCHMARK(coverage_of_24_m)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void coverage_at_50_Hz(benchmark::State& state) { run(state, {4, 50, 2.5, 0.05, 100000, 1}); }
BENCHMARK(coverage_at_50_Hz)->Unit(benchmark::kMillisecond);

/// Of this thread alone: what else the machine does is no matter of the engine.
double cpu_micros() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Latencies of single fixes, in processor time.
void latencies(benchmark::State& state, const Work& work) {
  const std::vector<WorkedStep> steps = boustrophedon(work);
  const Region field = field_of(work);
  std::vector<double> micros;
  double sum = 0;
  for (auto _ : state) {
    TileCoverage engine(field, {tile_of(work), true});
    micros.clear();
    for (const WorkedStep& step : steps) {
      const double begin = cpu_micros();
      engine.add(step);
      sum += engine.areas().missed_m2;
      micros.push_back(cpu_micros() - begin);
    }
  }
  benchmark::DoNotOptimize(sum);
  count_quantiles(std::move(micros), state);
  state.counters["quads/s"] = benchmark::Counter(quads_in(steps) * static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}

void fixes_with_48_sections(benchmark::State& state) {
  latencies(state, {24, static_cast<double>(state.range(0)), 2.5, 0.05, 50000, 48});
}
BENCHMARK(fixes_with_48_sections)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond);

/// The drive like Zhang's, of which the mesh engine's costs are measured (mesh_bench.cpp); covered, repeated
/// and missed areas after every point.
void exact_coverage(benchmark::State& state) {
  const std::vector<WorkedStep> steps = irregular_route();
  const auto count = static_cast<std::size_t>(state.range(0)) - 1;
  const Region field = irregular_field();
  double sum = 0;
  for (auto _ : state) {
    TileCoverage engine(field, {coverage::tile_for(4, 1), true});
    for (std::size_t i = 0; i < count; ++i) {
      engine.add(steps[i]);
      sum += engine.areas().covered_m2 + engine.areas().repeated_m2 + engine.areas().missed_m2;
    }
  }
  benchmark::DoNotOptimize(sum);
}

/// The same, and at every point the missed ground as rings.
void exact_leakage(benchmark::State& state) {
  const std::vector<WorkedStep> steps = irregular_route();
  const auto count = static_cast<std::size_t>(state.range(0)) - 1;
  const Region field = irregular_field();
  std::size_t regions = 0;
  for (auto _ : state) {
    TileCoverage engine(field, {coverage::tile_for(4, 1), true});
    for (std::size_t i = 0; i < count; ++i) {
      engine.add(steps[i]);
      benchmark::DoNotOptimize(regions = engine.region(LandClass::kMissed).size());
    }
  }
  state.counters["regions"] = static_cast<double>(regions);
}

void points_of_s3(benchmark::internal::Benchmark* bench) {
  for (const int points : {100, 200, 300, 400, 500, 600, kIrregularPoints}) bench->Arg(points);
}
BENCHMARK(exact_coverage)->Apply(points_of_s3)->Unit(benchmark::kMillisecond);
BENCHMARK(exact_leakage)->Apply(points_of_s3)->Unit(benchmark::kMillisecond);

/// 400,000 fixes, and all regions at the end.
void regions_of_a_day(benchmark::State& state) {
  const Work work{4, 10, 2.5, 0.05, 400000, 1};
  TileCoverage engine(field_of(work), {tile_of(work), true});
  for (const WorkedStep& step : boustrophedon(work)) engine.add(step);
  const auto what = static_cast<LandClass>(state.range(0));
  std::size_t vertices = 0, polygons = 0;
  for (auto _ : state) {
    const Region region = engine.region(what);
    vertices = vertex_count(region);
    polygons = region.size();
  }
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["polygons"] = static_cast<double>(polygons);
}
BENCHMARK(regions_of_a_day)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
