// What the routes over the pentagon are said to work, and what polygon booleans say.

#include "coverage/pentagon_routes.h"

#include <gtest/gtest.h>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage::testing_routes {
namespace {

Region regions(const std::vector<Ring>& rings) {
  Region out;
  for (const Ring& ring : rings) out.push_back({ring, {}});
  return out;
}

TEST(PentagonRoutes, ThePentagonIsThatOfThePaper) {
  EXPECT_DOUBLE_EQ(area(pentagon()), 983.125);
  EXPECT_NEAR(perimeter(pentagon().front().outer), 123.900, 5e-4);
}

TEST(PentagonRoutes, AreAsTheTableHasThem) {
  ASSERT_EQ(routes().size(), 11U);
  for (const PentagonRoute& route : routes()) {
    SCOPED_TRACE(route.name);
    const Region covered = unite(regions(route.rectangles));
    Region twice;
    for (std::size_t i = 0; i < route.rectangles.size(); ++i) {
      EXPECT_GT(signed_area(route.rectangles[i]), 0);
      for (std::size_t j = 0; j < i; ++j)
        for (Polygon& part : intersection({{route.rectangles[i], {}}}, {{route.rectangles[j], {}}}))
          twice.push_back(std::move(part));
    }
    EXPECT_NEAR(area(covered), route.covered_m2, 0.005);
    EXPECT_NEAR(area(unite(twice)), route.repeated_m2, 0.005);
    EXPECT_NEAR(area(difference(pentagon(), covered)), route.missed_m2, 0.005);
  }
}

TEST(PentagonRoutes, StepsMakeUpTheRectangles) {
  for (const PentagonRoute& route : routes()) {
    SCOPED_TRACE(route.name);
    std::vector<Region> runs(route.rectangles.size());
    for (const WorkedStep& step : route.steps) {
      ASSERT_EQ(step.quads.size(), 1U);
      const Quad& quad = step.quads.front();
      EXPECT_LE(distance(quad[1], quad[2]), 1 + 1e-9);
      runs[static_cast<std::size_t>(step.run)].push_back({{quad.begin(), quad.end()}, {}});
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
      EXPECT_NEAR(area(symmetric_difference(unite(runs[i]), {{route.rectangles[i], {}}})), 0, 0.005);
  }
}

}  // namespace
}  // namespace tramline::coverage::testing_routes
