// Areas of crossing rows by inclusion and exclusion, against polygon booleans.

#include <gtest/gtest.h>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/convex_clip.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

/// Rows side by side that share their edges up to rounding.
std::vector<Ring> rows(std::mt19937_64& random, int count) {
  const auto uniform = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(uniform(0, 180))));
  const double left = uniform(-20, 0), width = uniform(2, 5);
  std::vector<Ring> out;
  for (int i = 0; i < count; ++i) {
    const double x0 = left + i * width, x1 = left + (i + 1) * width, y0 = uniform(-25, -5),
                 y1 = uniform(5, 25);
    out.push_back({frame.to_field({x0, y0}), frame.to_field({x1, y0}), frame.to_field({x1, y1}),
                   frame.to_field({x0, y1})});
  }
  return out;
}

TEST(ConvexClipProperties, AreaInUnionAgreesWithPolygonBooleans) {
  for (int i = 0; i < testing::case_count(300); ++i) {
    testing::SeededRandom random(i);
    const Ring ground = testing::random_star(random, {0, 0}, 10, 30, 11);
    std::vector<ConvexSet> sets;
    Region rectangles;
    for (int directions = 0; directions < 3; ++directions)
      for (Ring& row : rows(random, 5)) {
        sets.push_back(convex_set(row));
        rectangles.push_back({std::move(row), {}});
      }
    ASSERT_NEAR(area_in_union({ground}, sets), area(intersection(unite(rectangles), {{ground, {}}})), 1e-3);
  }
}

}  // namespace
}  // namespace tramline
