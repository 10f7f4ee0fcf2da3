// A live log, from the line to the figures: what `tramline watch` does with each line of a stream.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "quantiles.h"
#include "tramline/coverage/live/live_coverage.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/io/log/line_log.h"

namespace tramline::bench {
namespace {

/// Rows at 50 Hz of a machine 24 m wide with 48 sections, each switching once in a second on average; 2.5
/// m/s, up and down over 150 m with 5 % overlap and a centimetre of noise.
std::vector<std::string> table(std::size_t fixes) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> across(0, 0.01);
  std::bernoulli_distribution switches(0.02);
  std::string widths = "0.5", states(48, '1');
  for (int i = 1; i < 48; ++i) widths += "|0.5";
  std::vector<std::string> out{"time,lon,lat,width_m,sections"};
  for (std::size_t i = 0; i < fixes; ++i) {
    const std::size_t pass = i / 3000, place = i % 3000;
    const double along_m = 0.05 * static_cast<double>(pass % 2 == 0 ? place : 3000 - place);
    for (char& state : states)
      if (switches(random)) state = state == '1' ? '0' : '1';
    out.push_back(fmt::format("{:.2f},{:.10f},{:.10f},{},{}", 0.02 * static_cast<double>(i),
                              9.15 + (22.8 * static_cast<double>(pass) + across(random)) / 67500,
                              52.69 + along_m / 111200, widths, states));
  }
  return out;
}

double cpu_micros() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void lines_with_48_sections(benchmark::State& state) {
  const std::vector<std::string> lines = table(static_cast<std::size_t>(state.range(0)));
  LocalFrame frame;
  frame.geodetic = true;
  frame.origin_lon_deg = 9.15;
  frame.origin_lat_deg = 52.69;
  const Region field{{{{-10, 10}, {1500, 0}, {1520, 140}, {-20, 145}}, {}}};
  std::vector<double> micros;
  double sum = 0, all_s = 0;
  for (auto _ : state) {
    io::LineLog log({}, "the stream");
    coverage::LiveCoverage live(field, {});
    const FixPlacing place(Positions::kLonLat, frame, "the stream");
    micros.clear();
    for (const std::string& line : lines) {
      const double begin = cpu_micros();
      for (Fix fix : log.add(line)) {
        std::string why;
        fix.position = place(fix.position, why).value();
        live.add(fix, log.booms());
      }
      sum += live.areas().missed_m2;
      micros.push_back(cpu_micros() - begin);
    }
    all_s = 0;
    for (const double one : micros) all_s += 1e-6 * one;
  }
  benchmark::DoNotOptimize(sum);
  count_quantiles(std::move(micros), state);
  state.counters["share_of_core_at_50_Hz"] = all_s / (0.02 * static_cast<double>(lines.size()));
}
BENCHMARK(lines_with_48_sections)->Arg(50000)->Arg(200000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
