#include "tramline/geometry/polygon/convex_clip.h"

#include <gtest/gtest.h>

#include "support/box_ring.h"

namespace tramline::convex_clip_test {

using testing_support::box;
ConvexSet set(double x0, double y0, double x1, double y1) { return convex_set(box(x0, y0, x1, y1)); }

// A comb: clipping its teeth by a box yields several parts, and the area is their sum.
TEST(ConvexClip, KeepsTheAreaOfSeveralParts) {
  const Ring comb{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {3, 1},
                  {3, 4}, {2, 4}, {2, 1}, {1, 1}, {1, 4}, {0, 4}};
  EXPECT_NEAR(signed_area(clipped({comb}, set(0, 2, 5, 3))), 3, 1e-12);
}

TEST(ConvexClip, TakesHolesOff) {
  const RingSet with_hole{box(0, 0, 10, 10), {{4, 4}, {4, 6}, {6, 6}, {6, 4}}};
  EXPECT_NEAR(signed_area(clipped(with_hole, set(5, 0, 15, 10))), 50 - 2, 1e-12);
}

// Three boxes over a square: 4 + 4 + 4, pairwise overlaps 1, 1 and 0, triple 0.
TEST(ConvexClip, UnionsByInclusionAndExclusion) {
  const RingSet square{box(0, 0, 10, 10)};
  EXPECT_NEAR(area_in_union(square, {set(0, 0, 2, 2), set(1, 1, 3, 3), set(2, 2, 4, 4)}), 10, 1e-12);
  // All three share [1,2]²: 3·4 − (2 + 2 + 1) + 1.
  EXPECT_NEAR(area_in_union(square, {set(0, 0, 2, 2), set(0, 1, 2, 3), set(1, 0, 3, 2)}), 8, 1e-12);
  // What sticks out of the square does not count.
  EXPECT_NEAR(area_in_union(square, {set(9, 9, 12, 12)}), 1, 1e-12);
}

}  // namespace tramline::convex_clip_test
