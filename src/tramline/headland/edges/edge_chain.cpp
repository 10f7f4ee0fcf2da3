#include "tramline/headland/edges/edge_chain.h"

#include <cassert>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

Point unit(Point from, Point to) { return (1 / distance(from, to)) * (to - from); }

void append_end_of(const Ring& ring, std::size_t edge, EdgeChain& chain) {
  const Point to = ring[(edge + 1) % ring.size()];
  if (chain.empty()) chain.push_back(ring[edge]);
  if (distance(chain.back(), to) > kSamePlace_m) chain.push_back(to);
}

}  // namespace

std::vector<EdgeChain> chains_with(const Ring& ring, const std::vector<int>& edge_passes, int number) {
  assert(edge_passes.size() == ring.size());
  const std::size_t n = ring.size();
  const auto has = [&](std::size_t edge) { return edge_passes[edge % n] >= number; };
  std::vector<EdgeChain> out;
  for (std::size_t first = 0; first < n; ++first) {
    if (!has(first) || has(first + n - 1)) continue;
    EdgeChain chain;
    for (std::size_t edge = first; has(edge); ++edge) append_end_of(ring, edge % n, chain);
    if (chain.size() > 1) out.push_back(std::move(chain));
  }
  return out;
}

ChainEnd first_end(const EdgeChain& chain) {
  const Point ahead = unit(chain[1], chain[0]);
  return {chain.front(), ahead, right_of(ahead)};
}

ChainEnd last_end(const EdgeChain& chain) {
  const Point ahead = unit(chain[chain.size() - 2], chain.back());
  return {chain.back(), ahead, left_of(ahead)};
}

}  // namespace tramline
