// Tours against the same tours driven from their ends, and against those found with more patience.

#include "tramline/route/build/track_tour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/seeds.h"
#include "route/tracks_to_join.h"

namespace tramline::track_tour_test {

using testing::for_each_seed;
using testing::TracksToJoin;

double seconds_of(const TrackTour& tour) {
  double out = 0;
  for (const Way& way : tour.ways) out += way.cost_s;
  return out;
}

auto lacking(const TrackTour& tour) {
  return std::ranges::count_if(tour.ways, [](const Way& way) { return !way.has_room(); });
}

/// Where nothing reaches out, a tour costs about as much from its end: looking at one sense is enough.
TEST(WithWays, OneSenseIsEnoughForABar) {
  double one_s = 0, both_s = 0;
  for_each_seed(60, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    KnownCosts costs(scene.lines, scene.connector, scene.least);
    order::Tour tour;
    for (std::size_t i = 0; i < scene.lines.size(); ++i) tour.push_back(2 * i + i % 2);
    for (int swaps = any_of(random, 0, 2); swaps > 0; --swaps)
      std::swap(tour[static_cast<std::size_t>(any_of(random, 0, static_cast<int>(tour.size()) - 1))],
                tour.front());
    const TrackTour one = with_ways(tour, Senses::kCostTheSame, costs),
                    both = with_ways(tour, Senses::kDiffer, costs);
    EXPECT_EQ(one.ways.size() + 1, scene.lines.size());
    EXPECT_EQ(lacking(one), lacking(both));
    EXPECT_LE(seconds_of(one), 1.1 * seconds_of(both) + 1);
    one_s += seconds_of(one);
    both_s += seconds_of(both);
  });
  EXPECT_LE(one_s, 1.01 * both_s);
  EXPECT_GT(both_s, 0);
}

/// The tours that were settled with less patience are among those with more.
TEST(BestTourWithWays, IsNoWorseWithMorePatience) {
  int better = 0;
  for_each_seed(40, [&](std::mt19937_64& random, int) {
    const TracksToJoin scene(random);
    const auto found = [&](Patience patience) {
      KnownCosts costs(scene.lines, scene.connector, scene.least);
      return best_tour_with_ways({}, Senses::kDiffer, patience, costs);
    };
    const TrackTour usual = found(Patience::kUsual), longer = found(Patience::kLong);
    EXPECT_LE(lacking(longer), lacking(usual));
    if (lacking(longer) == lacking(usual)) {
      EXPECT_LE(seconds_of(longer), seconds_of(usual) + 1e-6);
    }
    if (!usual.gave_up) {
      EXPECT_EQ(longer.tour, usual.tour);
    }
    if (seconds_of(longer) < seconds_of(usual) - 0.1) ++better;
  });
  if (testing::case_count(40) < 40) return;
  EXPECT_GT(better, 0);
}

}  // namespace tramline::track_tour_test
