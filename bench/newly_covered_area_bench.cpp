// What it costs to learn how much ground a detour round an obstacle would newly cover: the inner loop of
// a search over detours.

#include <benchmark/benchmark.h>

#include <cmath>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::bench {
namespace {

constexpr double kWidth = 3;
constexpr Box kWindow{-1.6, 0, 6, 60};

const Ring kField{{-80, -90}, {70, -95}, {120, -20}, {110, 80}, {20, 130}, {-60, 95}, {-100, 10}};

/// Out by an S, along an obstacle and back by another one.
Path detour() {
  constexpr double kRadius = 6, kAngle = 0.6;
  const double out = kRadius * (1 - std::cos(kAngle)), up = kRadius * std::sin(kAngle);
  const Point begin{0, 14};
  const Point a = begin + Point{out, up}, b = a + Point{out, up}, c = b + Point{0, 12};
  const Point d = c + Point{-out, up}, e = d + Point{-out, up};
  return {
      {begin, a, -1 / kRadius}, {a, b, 1 / kRadius}, {b, c, 0}, {c, d, 1 / kRadius}, {d, e, -1 / kRadius}};
}

Ring obstacle() {
  Ring ring;
  for (int i = 0; i < 8; ++i)
    ring.push_back({-1.5 + 2.2 * std::cos(0.2 + 0.785 * i), 27 + 7 * std::sin(0.2 + 0.785 * i)});
  return ring;
}

/// The field with its hole, and the rows beside the detour, one of them broken off at the obstacle.
RisingCurves surroundings() {
  RisingCurves curves;
  append_ring(kField, Layer::kBody, kWindow, curves);
  append_ring(reversed(obstacle()), Layer::kBody, kWindow, curves);
  append_box({-1.5, -50, 1.5, 19}, Layer::kCovered, kWindow, curves);
  append_box({-1.5, 37, 1.5, 90}, Layer::kCovered, kWindow, curves);
  append_box({1.5, -60, 4.5, 95}, Layer::kCovered, kWindow, curves);
  return curves;
}

void new_area_of_a_detour(benchmark::State& state) {
  RisingCurves curves = surroundings();
  append_band(detour(), kWidth, Layer::kNew, curves);
  state.counters["curves"] = static_cast<double>(curves.size());
  for (auto _ : state) benchmark::DoNotOptimize(newly_covered_area(curves));
}
BENCHMARK(new_area_of_a_detour);

void band_and_new_area_of_a_detour(benchmark::State& state) {
  RisingCurves curves = surroundings();
  const std::size_t kept = curves.size();
  const Path path = detour();
  for (auto _ : state) {
    curves.resize(kept);
    append_band(path, kWidth, Layer::kNew, curves);
    benchmark::DoNotOptimize(newly_covered_area(curves));
  }
}
BENCHMARK(band_and_new_area_of_a_detour);

void surroundings_of_a_detour(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(surroundings());
}
BENCHMARK(surroundings_of_a_detour);

/// The road through polygon booleans, with chords.
void boolean_new_area_of_a_detour(benchmark::State& state) {
  const Region body{{kField, {reversed(obstacle())}}};
  const Region taken{{{{-1.5, -50}, {1.5, -50}, {1.5, 19}, {-1.5, 19}}, {}},
                     {{{-1.5, 37}, {1.5, 37}, {1.5, 90}, {-1.5, 90}}, {}},
                     {{{1.5, -60}, {4.5, -60}, {4.5, 95}, {1.5, 95}}, {}}};
  for (auto _ : state) {
    const Region ground{{band(detour(), kWidth), {}}};
    benchmark::DoNotOptimize(area(intersection(difference(ground, unite(taken)), body)));
  }
}
BENCHMARK(boolean_new_area_of_a_detour)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tramline::bench
