#include "tramline/cost/grid/grid_tally.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

// A trapezium whose slanting side strips of 2 m cross in runs of 2 m: each end of a strip costs what the
// wedge of ½·w²·cot φ says, by hand 2 m² times f² over and (1 − f)² under.
TEST(GridTally, WedgesAtASlantingEdgeCostWhatTheFormulaSays) {
  const Polygon shape{{{0, 0}, {10, 0}, {10, 30}, {0, 20}}, {}};
  const TrackFrame north(Direction::clockwise_from_north(Angle::degrees(0)));
  for (const double share : {0.25, 0.5, 0.75}) {
    const GridTally tally(north, shape, {}, {2, 0, {false, (1 - share) * 2}});
    const Tally five = tally.at(0);
    EXPECT_EQ(five.pieces, 5);
    // The width still inside has fallen to (1 − share) of w where the swath has run on by `share`.
    EXPECT_NEAR(five.overlap_m2, 5 * 2 * share * share, 1e-9);
    EXPECT_NEAR(five.uncovered_m2, 5 * 2 * (1 - share) * (1 - share), 1e-9);
  }
}

}  // namespace
}  // namespace tramline
