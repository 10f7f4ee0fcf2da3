#include "tramline/route/search/exchange_chain.h"

#include <algorithm>
#include <array>

#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// How many ends are tried at each depth.
constexpr std::array<std::size_t, 6> kTried{5, 3, 2, 1, 1, 1};

struct ChainStep {
  End end = 0;
  double ahead_s = 0;  ///< after its connection is taken away
};

}  // namespace

double ExchangeChain::improve(End first) { return extend(first, tour_.mate(first), tour_.mate_s(first), 0); }

/// `first` and `loose` are mates whose connection counts as taken away.
double ExchangeChain::extend(End first, End loose, double ahead_s, std::size_t depth) {
  std::array<ChainStep, kTried.front()> steps;
  std::size_t count = 0;
  const auto look_at = [&](End end) {
    if (!tour_.may_exchange(loose, end)) return;
    const ChainStep step{end, ahead_s - tour_.between(loose, end) + tour_.mate_s(end)};
    std::size_t at = count < kTried[depth] ? count++ : count;
    while (at > 0 && steps[at - 1].ahead_s < step.ahead_s) {
      if (at < count) steps[at] = steps[at - 1];
      --at;
    }
    if (at < count) steps[at] = step;
  };
  for (const End end : neighbours_[loose]) {
    if (ahead_s - tour_.between(loose, end) <= kSameTime_s) break;
    look_at(end);
  }
  for (const End end : {tour_.start(), tour_.finish()})
    if (end != loose && ahead_s - tour_.between(loose, end) > kSameTime_s) look_at(end);
  for (std::size_t i = 0; i < count; ++i) {
    const End next_loose = tour_.mate(steps[i].end);
    const std::size_t changes = tour_.changes();
    tour_.exchange(loose, steps[i].end);
    const double gain = steps[i].ahead_s - tour_.mate_s(first);
    if (gain > kSameTime_s) return gain;
    if (depth + 1 < kTried.size()) {
      const double further = extend(first, next_loose, steps[i].ahead_s, depth + 1);
      if (further > 0) return further;
    }
    tour_.undo_to(changes);
  }
  return 0;
}

}  // namespace tramline::order
