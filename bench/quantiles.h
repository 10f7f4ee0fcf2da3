#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tramline::bench {

/// Median, 99.9th percentile and maximum of times as counters of a benchmark, µs.
inline void count_quantiles(std::vector<double> micros, benchmark::State& state) {
  std::sort(micros.begin(), micros.end());
  const auto quantile = [&](double share) {
    return micros[static_cast<std::size_t>(share * static_cast<double>(micros.size() - 1))];
  };
  state.counters["p50_us"] = quantile(0.5);
  state.counters["p99.9_us"] = quantile(0.999);
  state.counters["max_us"] = quantile(1);
}

}  // namespace tramline::bench
