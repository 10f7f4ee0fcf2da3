// What manoeuvres between two poses cost: the shortest lengths, which searches ask for by the million, and
// all manoeuvres of a machine.

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline::bench {
namespace {

constexpr double kRadius = 6;

/// Poses within a hundred metres.
std::vector<Pose> poses() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-50, 50), angle(0, 360);
  std::vector<Pose> out;
  for (int i = 0; i < 1024; ++i) {
    const double x = place(random), y = place(random);
    out.push_back({{x, y}, Heading::clockwise_from_north(Angle::degrees(angle(random)))});
  }
  return out;
}

template <class Measure>
void over_pairs(benchmark::State& state, Measure measure) {
  const std::vector<Pose> all = poses();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(measure(all[i % 1024], all[(i * 7 + 1) % 1024]));
    ++i;
  }
}

void shortest_dubins_length(benchmark::State& state) {
  over_pairs(state, [](const Pose& from, const Pose& to) { return dubins_length(from, to, kRadius); });
}
BENCHMARK(shortest_dubins_length);

void shortest_reeds_shepp_length(benchmark::State& state) {
  over_pairs(state, [](const Pose& from, const Pose& to) { return reeds_shepp_length(from, to, kRadius); });
}
BENCHMARK(shortest_reeds_shepp_length);

void manoeuvres_of_a_machine(benchmark::State& state, bool reverse, double steering_time_s) {
  Machine machine;
  machine.radius_m = kRadius;
  machine.turning.reverse = reverse;
  machine.turning.steering_time_s = steering_time_s;
  over_pairs(state,
             [&](const Pose& from, const Pose& to) { return manoeuvres_between(from, to, machine).size(); });
}
BENCHMARK_CAPTURE(manoeuvres_of_a_machine, forward, false, 0.0);
BENCHMARK_CAPTURE(manoeuvres_of_a_machine, reversing, true, 0.0);
BENCHMARK_CAPTURE(manoeuvres_of_a_machine, forward_with_clothoids, false, 2.0);
BENCHMARK_CAPTURE(manoeuvres_of_a_machine, reversing_with_clothoids, true, 2.0);

}  // namespace
}  // namespace tramline::bench
