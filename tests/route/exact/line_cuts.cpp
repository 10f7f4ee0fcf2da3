#include "route/exact/line_cuts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tramline::testing {

std::vector<std::vector<bool>> WeightedLines::sets_cut_below(double least) const {
  std::vector<std::vector<double>> weights = weights_;
  std::vector<std::vector<std::size_t>> merged(weights.size());  // lines that count as one
  for (std::size_t i = 0; i < merged.size(); ++i) merged[i] = {i};
  std::vector<std::size_t> remaining(weights.size());
  std::iota(remaining.begin(), remaining.end(), 0);
  std::vector<std::vector<bool>> out;
  while (remaining.size() > 1) {
    // Each time the one most strongly connected with those before is added.
    std::vector<double> strength(weights.size(), 0);
    std::vector<std::size_t> waiting = remaining;
    std::size_t last = waiting.front(), before = last;
    double cut = 0;
    while (!waiting.empty()) {
      const auto strongest = std::max_element(waiting.begin(), waiting.end(),
                                              [&](auto a, auto b) { return strength[a] < strength[b]; });
      before = std::exchange(last, *strongest);
      cut = strength[last];
      waiting.erase(strongest);
      for (const std::size_t other : waiting) strength[other] += weights[last][other];
    }
    if (cut < least) {
      std::vector<bool> inside(weights.size(), false);
      for (const std::size_t line : merged[last]) inside[line] = true;
      out.push_back(std::move(inside));
    }
    for (const std::size_t other : remaining) {
      weights[before][other] += weights[last][other];
      weights[other][before] += weights[other][last];
    }
    merged[before].insert(merged[before].end(), merged[last].begin(), merged[last].end());
    std::erase(remaining, last);
  }
  return out;
}

}  // namespace tramline::testing
