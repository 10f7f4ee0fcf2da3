// What Zhang's engine costs on a drive like its own: Zhang tables 2 and 3.

#include <benchmark/benchmark.h>

#include "irregular_route.h"
#include "tramline/coverage/mesh/connected_rings.h"
#include "tramline/coverage/mesh/mesh_coverage.h"

namespace tramline::bench {
namespace {

using coverage::MeshCoverage;
using coverage::WorkedStep;

void points_and_meshes(benchmark::internal::Benchmark* bench) {
  for (const int mesh_mm : {50, 20})
    for (const int points : {100, 200, 300, 400, 500, 600, kIrregularPoints}) bench->Args({points, mesh_mm});
}

double mesh_m(const benchmark::State& state) { return 1e-3 * static_cast<double>(state.range(1)); }

/// Coverage and repeated ground, kept up to date at every point.
void mesh_coverage(benchmark::State& state) {
  const std::vector<WorkedStep> steps = irregular_route();
  const auto count = static_cast<std::size_t>(state.range(0)) - 1;
  std::size_t meshes = 0;
  Region covered;
  for (auto _ : state) {
    MeshCoverage engine(irregular_field(), mesh_m(state));
    for (std::size_t i = 0; i < count; ++i) engine.add(steps[i]);
    benchmark::DoNotOptimize(engine);
    state.PauseTiming();
    meshes = engine.covered().meshes();
    covered = engine.region(LandClass::kCovered);
    state.ResumeTiming();
  }
  state.counters["meshes"] = static_cast<double>(meshes);
  state.counters["boundaries"] = static_cast<double>(rings_of(covered).size());
}
BENCHMARK(mesh_coverage)->Apply(points_and_meshes)->Unit(benchmark::kMillisecond);

/// The same, and at every point the leakage with its rings, as Zhang table 2 has it.
void mesh_leakage(benchmark::State& state) {
  const std::vector<WorkedStep> steps = irregular_route();
  const auto count = static_cast<std::size_t>(state.range(0)) - 1;
  std::size_t meshes = 0, regions = 0;
  for (auto _ : state) {
    MeshCoverage engine(irregular_field(), mesh_m(state));
    for (std::size_t i = 0; i < count; ++i) {
      engine.add(steps[i]);
      benchmark::DoNotOptimize(regions = engine.region(LandClass::kMissed).size());
    }
    meshes = engine.missed().meshes();
  }
  state.counters["meshes"] = static_cast<double>(meshes);
  state.counters["regions"] = static_cast<double>(regions);
}
BENCHMARK(mesh_leakage)->Apply(points_and_meshes)->Unit(benchmark::kMillisecond);

/// Rows of 500 m, 12 m wide, 0.1 m of it worked twice, in steps of 2 m: does a quad cost more as the day goes
/// on? On a slant, where boundaries have the most meshes.
void mesh_long_drive(benchmark::State& state) {
  constexpr int kStepsPerRow = 250;
  const auto place = [](double x, double y) { return Point{0.96 * x - 0.28 * y, 0.28 * x + 0.96 * y}; };
  for (auto _ : state) {
    MeshCoverage engine({}, coverage::kMesh_m);
    for (int i = 0; i < state.range(0); ++i) {
      const int row = i / kStepsPerRow, along = i % kStepsPerRow;
      const double ahead = row % 2 == 0 ? 2 : -2;
      const double x = row % 2 == 0 ? 2.0 * along : 500 - 2.0 * along, y = 11.9 * row;
      engine.add(
          {{{place(x, y + 12), place(x, y), place(x + ahead, y), place(x + ahead, y + 12)}}, row, 0, 12, 0});
    }
    benchmark::DoNotOptimize(engine);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(mesh_long_drive)->Arg(1000)->Arg(3000)->Arg(10000)->Arg(30000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
