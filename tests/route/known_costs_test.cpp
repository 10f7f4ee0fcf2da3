// What ways that were looked for tell of others.

#include "tramline/route/build/known_costs.h"

#include <gtest/gtest.h>

#include <algorithm>

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
