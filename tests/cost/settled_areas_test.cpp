// What is worked usefully is neither more than all work nor more than all land.

#include "tramline/cost/settled_areas.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

Tally settled(double worked_m2, double useful_m2, double body_m2) {
  Tally out;
  out.worked_m2 = worked_m2;
  out.overlap_m2 = out.uncovered_m2 = 99;  // of an earlier state
  settle_areas(out, useful_m2, body_m2);
  return out;
}

TEST(SettledAreas, AreTheRestsOfWorkAndLand) {
  const Tally tally = settled(120, 90, 100);
  EXPECT_EQ(tally.worked_m2, 120);
  EXPECT_EQ(tally.overlap_m2, 30);
  EXPECT_EQ(tally.uncovered_m2, 10);
}

TEST(SettledAreas, AreNotNegativeWhereRoundingExceedsWorkOrLand) {
  const Tally all_land = settled(120, 100 + 1e-5, 100);
  EXPECT_EQ(all_land.overlap_m2, 20);
  EXPECT_EQ(all_land.uncovered_m2, 0);
  const Tally all_work = settled(80, 80 + 1e-5, 100);
  EXPECT_EQ(all_work.overlap_m2, 0);
  EXPECT_EQ(all_work.uncovered_m2, 20);
}

// The identity of Tally: worked = body − uncovered + overlap.
TEST(SettledAreas, KeepTheIdentity) {
  for (const double useful : {0.0, 55.5, 79.9, 80.1, 300.0}) {
    const Tally tally = settled(80, useful, 100);
    EXPECT_DOUBLE_EQ(tally.worked_m2, 100 - tally.uncovered_m2 + tally.overlap_m2);
  }
}

}  // namespace
}  // namespace tramline
