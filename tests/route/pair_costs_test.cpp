// A hash table of costs by pairs of ends, against an ordered map.

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "tramline/route/build/pair_costs.h"

namespace tramline {
namespace {

TEST(PairCosts, AreThoseOfAMapByPairsInEitherOrder) {
  for_each_seed(50, [](std::mt19937_64& random, int) {
    const int ends = any_of(random, 2, 200);
    PairCosts costs(static_cast<std::size_t>(any_of(random, 0, 1) * any_of(random, 0, 3000)));
    std::map<std::pair<std::size_t, std::size_t>, double> expected;
    double next = 0;
    for (int i = 0; i < 5000; ++i) {
      const auto a = static_cast<std::size_t>(any_of(random, 0, ends - 1)),
                 b = static_cast<std::size_t>(any_of(random, 0, ends - 1));
      if (a == b) continue;
      const std::pair<std::size_t, std::size_t> pair = std::minmax(a, b);
      switch (any_of(random, 0, 1000)) {
        case 0:
          costs.clear();
          expected.clear();
          break;
        case 1:
          if (expected.contains(pair)) expected[pair] = -1;
          costs.change(a, b, -1);
          break;
        default: {
          ++next;
          const auto [known, is_new] = expected.try_emplace(pair, next);
          ASSERT_EQ(costs.known_or(a, b, [&] { return next; }), known->second);
        }
      }
    }
  });
}

}  // namespace
}  // namespace tramline
