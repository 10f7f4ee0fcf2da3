// The boundary cut at strips, against clipping by polygon booleans.

#include "tramline/cost/bound/strip_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// Of north-bound strips, with line 0 at x = 0.
StripGrid north_strips(double width_m) { return {TrackFrame(), 0, width_m}; }

/// Of the region in a strip: ∮ −y dx, to which nothing beyond the sides adds, for x stays there as it is.
double area_below_parts(std::span<const BoundaryPart> parts) {
  double sum = 0;
  for (const BoundaryPart& part : parts) sum -= 0.5 * (part.from.y + part.to.y) * (part.to.x - part.from.x);
  return sum;
}

double length_of_parts(std::span<const BoundaryPart> parts) {
  double sum = 0;
  for (const BoundaryPart& part : parts) sum += distance(part.from, part.to);
  return sum;
}

bool holds(std::span<const BoundaryPart> parts, Point from, Point to) {
  return std::any_of(parts.begin(), parts.end(), [&](const BoundaryPart& part) {
    return distance(part.from, from) < 1e-12 && distance(part.to, to) < 1e-12;
  });
}

// Strips of 4 m over a triangle: the edge from (10, 0) up to (2, 8) passes y = 2 at the line x = 8 and y = 6
// at the line x = 4.
TEST(StripParts, OfATriangleEndAtTheSidesOfTheStrips) {
  StripParts parts;
  const StripGrid grid = north_strips(4);
  parts.collect({{{2, 0}, {10, 0}, {2, 8}}}, grid, {0, 2}, 0);
  const auto first = parts.in(0), second = parts.in(1), third = parts.in(2);
  ASSERT_EQ(first.size(), 3u);
  EXPECT_TRUE(holds(first, {2, 0}, {4, 0}));
  EXPECT_TRUE(holds(first, {4, 6}, {2, 8}));
  EXPECT_TRUE(holds(first, {2, 8}, {2, 0}));
  ASSERT_EQ(second.size(), 2u);
  EXPECT_TRUE(holds(second, {0, 0}, {4, 0}));
  EXPECT_TRUE(holds(second, {4, 2}, {0, 6}));
  ASSERT_EQ(third.size(), 2u);
  EXPECT_TRUE(holds(third, {0, 0}, {2, 0}));
  EXPECT_TRUE(holds(third, {2, 0}, {0, 2}));
}

// The same strips half a metre wider on either side: the side x = 2 is in the first one only, and the part
// that the second and the third both see lies in both.
TEST(StripParts, OfWiderStripsLieInBoth) {
  StripParts parts;
  const StripGrid grid = north_strips(4);
  parts.collect({{{2, 0}, {10, 0}, {2, 8}}}, grid, {1, 2}, 0.5);
  ASSERT_EQ(parts.in(0).size(), 2u);
  EXPECT_TRUE(holds(parts.in(0), {4.5, 1.5}, {-0.5, 6.5}));
  EXPECT_TRUE(holds(parts.in(0), {-0.5, 0}, {4.5, 0}));
  ASSERT_EQ(parts.in(1).size(), 2u);
  EXPECT_TRUE(holds(parts.in(1), {2, 0}, {-0.5, 2.5}));
}

TEST(StripParts, KnowTheirEndsAlong) {
  const BoundaryPart falling{{0, 7}, {1, 3}};
  EXPECT_EQ(falling.lowest(), 3);
  EXPECT_EQ(falling.highest(), 7);
}

TEST(StripParts, HaveTheAreaAndTheLengthInEveryStrip) {
  StripParts parts;  // one for all cases: nothing may be left of the case before
  testing::for_each_seed(60, [&](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> width(2, 15), share(0, 0.9);
    const Ring outer = testing::random_star(random, {3, -5}, 20, 60, 3 + number % 15);
    Ring hole = testing::random_star(random, {3, -5}, 2, 6, 3 + number % 5);
    const double width_m = width(random), margin_m = number % 3 == 0 ? 0 : share(random) * width_m;
    const Region region = difference({{outer, {}}}, {{hole, {}}});
    const StripGrid grid = north_strips(width_m);
    // The strips at the ends miss the boundary, or part of it.
    const StripRange range{grid.strip_at(-40), grid.strip_at(45)};
    const std::vector<Ring> rings = rings_of(region);
    parts.collect(rings, grid, range, margin_m);
    for (int k = range.first; k <= range.last; ++k) {
      const auto in_strip = parts.in(static_cast<std::size_t>(k - range.first));
      const double left = grid.line(k) - margin_m, right = grid.line(k + 1) + margin_m;
      const Region strip{{{{left, -99}, {right, -99}, {right, 99}, {left, 99}}, {}}};
      ASSERT_NEAR(area_below_parts(in_strip), area(intersection(region, strip)), 1e-3) << "strip " << k;
      double length_m = 0;
      for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          length_m += length_inside(strip, ring[i], ring[(i + 1) % ring.size()]);
      ASSERT_NEAR(length_of_parts(in_strip), length_m, 1e-6) << "strip " << k;
      for (const BoundaryPart& part : in_strip)
        for (const Point p : {part.from, part.to}) {
          ASSERT_GE(p.x, -margin_m);
          ASSERT_LE(p.x, width_m + margin_m);
        }
    }
  });
}

}  // namespace
}  // namespace tramline
