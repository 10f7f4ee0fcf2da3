// Expected stretches by hand: a strip 4 m wide whose land ends at y = 0, and above along a line from its
// right side at y = 3 to its left at y = 11, so that half a metre less of a row lies inside with each metre
// along.

#include "tramline/cost/bound/undriven_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace tramline {
namespace {

constexpr double kNear = 1e-4;  // widths have a tolerance

class UndrivenRows : public ::testing::Test {
 protected:
  Intervals in(const RowBoundTerms& moving, const DrivenTerms& driven) {
    gather_windows(parts_, moving.width_m, 0, 2 * driven.shear_m, windows_);
    Intervals out;
    find_undriven_rows(windows_, moving, driven, out);
    return out;
  }

  std::vector<BoundaryPart> parts_{{{0, 0}, {4, 0}}, {{4, 3}, {0, 11}}};
  std::vector<BoundaryWindow> windows_;
  RowBoundTerms still_{4, 1, 1, 0, 0, 0};
};

TEST_F(UndrivenRows, AreThoseTooNarrowForTheEndRule) {
  const Intervals inside = in(still_, {4, 1, 0});
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_NEAR(inside[0].from, 3, kNear);
  EXPECT_NEAR(inside[0].to, 11, kNear);
  const Intervals half = in(still_, {2, 1, 0});
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(half[0].from, 7, kNear);
}

TEST_F(UndrivenRows, AreAllRowsWhereWideOnesAreTooFewForAPiece) {
  const Intervals too_short = in(still_, {4, 3.1, 0});
  ASSERT_EQ(too_short.size(), 1u);
  EXPECT_NEAR(too_short[0].from, 0, kNear);
  EXPECT_NEAR(too_short[0].to, 11, kNear);
  EXPECT_NEAR(in(still_, {4, 2.9, 0}).at(0).from, 3, kNear);
}

TEST_F(UndrivenRows, AreFewerWhereTheBoundaryMoves) {
  // Half a metre more may lie inside: too narrow from the row of 1.5 m on.
  EXPECT_NEAR(in({4, 1, 1, 0, 0, 0.5}, {2, 1, 0}).at(0).from, 8, kNear);
  // Columns that move along by 0.1 m may add 0.5 × 0.2 m more; and so far beyond its end may the land reach.
  const Intervals sheared = in({4, 1, 1, 0, 0, 0.5}, {2, 1, 0.1});
  EXPECT_NEAR(sheared.at(0).from, 8.2, kNear);
  EXPECT_NEAR(sheared.at(0).to, 11.1, kNear);
}

// A waist too narrow to be driven, between two stretches 6 m and 2 m long.
TEST_F(UndrivenRows, AreShortStretchesBetweenNarrowOnes) {
  parts_ = {{{0, 0}, {4, 0}}, {{4, 0}, {4, 6}},  {{4, 6}, {1, 6}},  {{1, 6}, {1, 8}},
            {{1, 8}, {4, 8}}, {{4, 8}, {4, 10}}, {{4, 10}, {0, 10}}};
  const Intervals left = in(still_, {4, 5, 0});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_NEAR(left[0].from, 6, kNear);
  EXPECT_NEAR(left[0].to, 10, kNear);
}

}  // namespace
}  // namespace tramline
