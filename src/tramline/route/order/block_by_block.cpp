#include <algorithm>
#include <array>
#include <limits>

#include "tramline/route/order/point_grid.h"
#include "tramline/route/order/shorten.h"
#include "tramline/route/order/tours.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

constexpr int kRounds = 5;

/// The ways of driving a block up and down: from the start of its first line, from the end of it, and the
/// same two the other way round.
constexpr std::size_t kWays = 4;

Tour driven(const Block& block, std::size_t way) {
  Tour out;
  for (std::size_t i = 0; i < block.size(); ++i) out.push_back(2 * block[i] + (i + way) % 2);
  return way < 2 ? out : backwards(out);
}

/// A block in each of its ways.
struct BlockWays {
  std::array<End, kWays> entry{};
  std::array<End, kWays> exit{};
  std::array<double, kWays> inner_m{};
};

BlockWays ways_of(const Block& block, HopCosts& costs) {
  BlockWays out;
  for (std::size_t way = 0; way < kWays; ++way) {
    const Tour tour = driven(block, way);
    out.entry[way] = tour.front();
    out.exit[way] = other_end(tour.back());
    out.inner_m[way] = cost(tour, costs);
  }
  return out;
}

struct DrivenBlock {
  std::size_t block = 0;
  std::size_t way = 0;
};

using BlockTour = std::vector<DrivenBlock>;

double cost_of(const BlockTour& tour, const std::vector<BlockWays>& ways, HopCosts& costs) {
  double out = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const DrivenBlock& at = tour[i];
    out += ways[at.block].inner_m[at.way];
    if (i > 0) out += costs.cost(ways[tour[i - 1].block].exit[tour[i - 1].way], ways[at.block].entry[at.way]);
  }
  return out;
}

/// Starts with the first block and always goes on to the nearest corner.
BlockTour nearest_corner_first(const std::vector<BlockWays>& ways, const HopCosts& costs) {
  std::vector<Point> corners;
  for (const BlockWays& block : ways)
    for (const End entry : block.entry) corners.push_back(costs.at(entry));
  PointGrid waiting(corners);
  BlockTour out;
  for (std::vector<std::size_t> next{0}; !next.empty();
       next = waiting.nearest(costs.at(ways[out.back().block].exit[out.back().way]), 1)) {
    out.push_back({next.front() / kWays, next.front() % kWays});
    for (std::size_t way = 0; way < kWays; ++way) waiting.remove(kWays * out.back().block + way);
  }
  return out;
}

/// The best ways for the order of the blocks, by dynamic programming; among equals the first. O(n)
void choose_ways(BlockTour& tour, const std::vector<BlockWays>& ways, HopCosts& costs) {
  struct Reached {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t from = 0;
  };
  std::vector<std::array<Reached, kWays>> reached(tour.size());
  for (std::size_t i = 0; i < tour.size(); ++i)
    for (std::size_t way = 0; way < kWays; ++way) {
      const BlockWays& at = ways[tour[i].block];
      Reached& best = reached[i][way];
      if (i == 0) best.cost = at.inner_m[way];
      for (std::size_t from = 0; i > 0 && from < kWays; ++from) {
        const double whole = reached[i - 1][from].cost + at.inner_m[way] +
                             costs.cost(ways[tour[i - 1].block].exit[from], at.entry[way]);
        if (whole < best.cost - kLeastGain_m) best = {whole, from};
      }
    }
  std::size_t way = 0;
  for (std::size_t other = 1; other < kWays; ++other)
    if (reached.back()[other].cost < reached.back()[way].cost - kLeastGain_m) way = other;
  for (std::size_t i = tour.size(); i-- > 0; way = reached[i][way].from) tour[i].way = way;
}

/// The order of the blocks shortened, each kept on the side it begins on.
void shorten_blocks(BlockTour& tour, const std::vector<BlockWays>& ways, HopCosts& costs) {
  std::vector<Stretch> stretches(ways.size());
  std::vector<std::size_t> way_of(ways.size());
  StretchTour order;
  for (const DrivenBlock& at : tour) {
    stretches[at.block].ends = {ways[at.block].entry[at.way], ways[at.block].exit[at.way]};
    way_of[at.block] = at.way;
    order.push_back(2 * at.block);
  }
  shorten(order, stretches, near_ends(stretches, costs), costs);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t block = order[i] / 2;
    tour[i] = {block, order[i] % 2 == 0 ? way_of[block] : (way_of[block] + 2) % kWays};
  }
}

}  // namespace

Tour block_by_block(const std::vector<Block>& blocks, HopCosts& costs) {
  std::vector<BlockWays> ways;
  for (const Block& block : blocks) ways.push_back(ways_of(block, costs));
  BlockTour tour = nearest_corner_first(ways, costs);
  choose_ways(tour, ways, costs);
  double least = cost_of(tour, ways, costs);
  for (int round = 0; round < kRounds; ++round) {
    BlockTour next = tour;
    shorten_blocks(next, ways, costs);
    choose_ways(next, ways, costs);
    const double shorter = cost_of(next, ways, costs);
    if (shorter >= least - kLeastGain_m) break;
    least = shorter;
    tour = std::move(next);
  }
  Tour out;
  for (const DrivenBlock& at : tour) {
    const Tour part = driven(blocks[at.block], at.way);
    out.insert(out.end(), part.begin(), part.end());
  }
  return out;
}

}  // namespace tramline::order
