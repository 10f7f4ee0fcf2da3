#include "request/map_directions.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

/// Edges at 90° (100 m), 86° (50 m), 0° (57 m), 95° (150 m; 94.995°) and 0° (73 m).
Field five_edges() {
  Field out;
  out.outer = {{0, 0}, {100, 0}, {149.878, 3.488}, {149.878, 60}, {0, 73.1}};
  return out;
}

void expect_degrees(const MapDirections& directions, const std::vector<double>& expected) {
  ASSERT_EQ(directions.all.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(directions.all[i].direction.degrees(), expected[i], 0.01);
}

// 90° is left to 95°; 86° is 9° from it and has nothing longer nearer than that in the table.
TEST(EdgeDirections, WithinFiveDegreesAreThatOfTheLongestEdge) {
  expect_degrees(edge_directions(five_edges(), Angle::degrees(1)), {95, 0, 86});
}

TEST(EdgeDirections, AreFartherApartWhereSubfieldsAreMergedFartherApart) {
  expect_degrees(edge_directions(five_edges(), Angle::degrees(10)), {95, 0});
}

}  // namespace
}  // namespace tramline::app
