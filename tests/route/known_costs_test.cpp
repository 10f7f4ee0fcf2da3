// What ways that were looked for tell of others.

#include "tramline/route/build/known_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "properties/seeds.h"
#include "route/tracks_to_join.h"

namespace tramline::known_costs_test {

using testing::for_each_seed;
using testing::TracksToJoin;

/// Ways from an end are expected to cost more once one was found that does: not less than before, and by no
/// more than that one. A way without room tells nothing of others.
TEST(KnownCosts, ExpectMoreWhereAWayCostMore) {
  int dearer = 0, without_room = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    const order::End a = 1, b = 3, c = 5;  // where the first three tracks end
    costs.expect_more();
    const double foreseen_s = costs.between(a, b), other_s = costs.between(a, c);
    const Way way = costs.way(a, b);
    const double more_s = costs.between(a, c) - other_s;
    if (!way.has_room()) {
      EXPECT_EQ(more_s, 0);
      ++without_room;
    } else if (const double excess_s = way.cost_s - foreseen_s; excess_s > 1) {
      EXPECT_GT(more_s, 0);
      EXPECT_LT(more_s, excess_s);
      ++dearer;
    }
  });
  EXPECT_GT(dearer, 10);
  std::cout << dearer << " ways dearer than foreseen, " << without_room << " without room\n";
}

/// The neighbours of an end are the cheapest of those looked at by what is known then: of ends whose ways
/// were looked for meanwhile, too.
TEST(KnownCosts, KeepNeighboursOfEndsWhoseCostsHaveNotChanged) {
  int changed = 0;
  for_each_seed(60, [&](std::mt19937_64& random, int i) {
    const TracksToJoin scene(random, i % 2 == 0);
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    const std::size_t ends = 2 * scene.lines.size();
    if (i % 3 == 0) costs.expect_more();
    for (int round = 0; round < 4; ++round) {
      const order::Neighbours before = costs.neighbours();
      for (int ways = 0; ways < 3; ++ways) {
        const order::End a = random() % ends, b = random() % ends;
        if (order::line_of(a) != order::line_of(b)) costs.way(a, b);
      }
      const order::Neighbours& after = costs.neighbours();
      if (after != before) ++changed;
      for (order::End end = 0; end < ends; ++end) {
        std::vector<std::pair<double, order::End>> all;
        for (order::End other = 0; other < ends; ++other)
          if (order::line_of(other) != order::line_of(end))
            all.emplace_back(costs.between(end, other), other);
        std::ranges::sort(all);
        ASSERT_EQ(after[end].size(), std::min(all.size(), order::NeighbourCounts{}.kept));
        for (std::size_t rank = 0; rank < after[end].size(); ++rank)
          ASSERT_EQ(after[end][rank], all[rank].second);
      }
    }
  });
  EXPECT_GT(changed, 10);
}

/// Three ways without room and none with it: no way of that end is expected to have room, until one has.
TEST(KnownCosts, ExpectNoRoomAtDeadEnds) {
  int dead = 0, alive = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int i) {
    const TracksToJoin scene(random, i % 2 == 0);
    if (scene.lines.size() < 6) return;
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    const order::End end = 1;
    const double foreseen_s = costs.between(end, 11);
    bool has_room = false;
    for (const order::End other : {3U, 5U, 7U}) has_room = costs.way(end, other).has_room() || has_room;
    if (has_room) {
      EXPECT_EQ(costs.between(end, 11), foreseen_s);
      ++alive;
    } else {
      EXPECT_GE(costs.between(end, 11), foreseen_s + 1000);
      ++dead;
    }
  });
  std::cout << dead << " dead ends, " << alive << " others\n";
  if (testing::case_count(40) < 40) return;
  EXPECT_GT(dead, 5);
  EXPECT_GT(alive, 5);
}

}  // namespace tramline::known_costs_test
