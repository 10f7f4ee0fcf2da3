#include "tramline/geometry/polygon/faces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tramline::faces_test {

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

TEST(Faces, OfAPolygonsEdgesAreThePolygon) {
  Polygon square = box(0, 0, 10, 10);
  square.holes = {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}};
  const Region faces = faces_of(edges_of(square));
  ASSERT_EQ(faces.size(), 1u);
  ASSERT_EQ(faces[0].holes.size(), 1u);
  EXPECT_NEAR(area(faces), 96, 1e-12);
}

TEST(Faces, AreTwoOnEitherSideOfACut) {
  auto edges = edges_of({{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}}, {}});
  edges.push_back({{5, 0}, {5, 10}});
  edges.push_back({{5, 10}, {5, 0}});
  const Region faces = faces_of(edges);
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_NEAR(area(faces[0]), 50, 1e-12);
}

TEST(Faces, KeepAHoleThatTouchesItsOuterRing) {
  Polygon square{{{0, 0}, {10, 0}, {10, 5}, {10, 10}, {0, 10}}, {{{10, 5}, {8, 4}, {8, 6}}}};
  const Region faces = faces_of(edges_of(square));
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].holes.size(), 1u);
  EXPECT_EQ(faces[0].outer.size(), 5u);
}

TEST(Faces, DoNotDependOnTheOrderOfTheEdges) {
  Polygon square = box(0, 0, 10, 10);
  square.holes = {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}};
  auto edges = edges_of(square);
  const Region forward = faces_of(edges);
  std::reverse(edges.begin(), edges.end());
  EXPECT_EQ(faces_of(edges), forward);
}

TEST(Dissolved, CellsLoseTheirCommonEdges) {
  const Region whole = dissolved({box(0, 0, 5, 10), box(5, 0, 10, 10)});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].outer.size(), 6u);  // the two nodes on the outline stay
  EXPECT_NEAR(area(whole), 100, 1e-12);
}

TEST(Dissolved, ARingOfCellsHasAHole) {
  const Region whole = dissolved({{{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}}, {}},
                                  {{{2, 1}, {3, 1}, {3, 2}, {2, 2}}, {}},
                                  {{{0, 2}, {1, 2}, {2, 2}, {3, 2}, {3, 3}, {0, 3}}, {}},
                                  {{{0, 1}, {1, 1}, {1, 2}, {0, 2}}, {}}});
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(whole[0].holes.size(), 1u);
  EXPECT_NEAR(area(whole), 8, 1e-12);
}

TEST(Dissolved, CellsThatTouchInAPointStayApart) {
  EXPECT_EQ(dissolved({box(0, 0, 1, 1), box(1, 1, 2, 2)}).size(), 2u);
}

}  // namespace tramline::faces_test
