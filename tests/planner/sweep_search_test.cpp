#include "tramline/planner/search/sweep_search.h"

#include <gtest/gtest.h>

#include "planner/prepared.h"

namespace tramline {
namespace {

std::vector<LinedSubfield> driven(const SearchTask& task, double degrees) {
  return {{{task.ground.plannable.front(), Direction::clockwise_from_north(Angle::degrees(degrees))}, 0}};
}

// Sixty that look cheap and are not stand before the one that is cheapest with all tracks cut.
TEST(SweepSearch, NeverCostsMoreThanToCutAllTracks) {
  Field field;
  field.outer = {{0, 0}, {30, 0}, {30, 300}, {0, 300}};
  const testing::Prepared prepared{{field, {}, {}, {}}};
  const SearchTask task = prepared.task();
  std::vector<SweptCandidate> swept;
  for (int i = 0; i < 60; ++i) swept.push_back({driven(task, 90), {1000, 1000, 0}});
  const double north = outlook_on(task, driven(task, 0)).cut;
  swept.push_back({driven(task, 0), {north, north, 1}});
  const auto found = cheapest_swept(task, swept, kAnyCost, SearchContext(1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cost(), north);
  EXPECT_LT(north, outlook_on(task, driven(task, 90)).cut);
}

}  // namespace
}  // namespace tramline
