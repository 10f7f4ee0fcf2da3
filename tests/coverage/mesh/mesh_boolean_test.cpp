#include "tramline/coverage/mesh/mesh_boolean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "coverage/mesh/mesh_oracle.h"
#include "support/box_ring.h"
#include "tramline/coverage/mesh/connected_rings.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

using testing_meshes::corners_of;
using testing_meshes::CornerSet;
using testing_meshes::difference;
using testing_meshes::random_rings;
using testing_meshes::together;

constexpr int kLow = -24, kHigh = 24;

using testing_support::box;

struct Operation {
  MeshOperation operation;
  const char* name;
  bool (*corner)(bool, bool);
};
constexpr Operation kOperations[] = {
    {MeshOperation::kUnion, "union", [](bool a, bool b) { return a || b; }},
    {MeshOperation::kIntersection, "intersection", [](bool a, bool b) { return a && b; }},
    {MeshOperation::kResidual, "residual", [](bool a, bool b) { return a && !b; }}};

/// Rings simple, valid, and round just the corners inside.
void expect_rings(const MeshRegion& region, const CornerSet& expected) {
  const Region polygons = region_of(region, 1);
  EXPECT_NEAR(area(polygons), static_cast<double>(expected.count()), 1e-9);
  for (const Polygon& polygon : polygons) {
    const auto fault = find_invalidity(polygon);
    EXPECT_FALSE(fault) << fault->reason << " at " << fault->place.x << ", " << fault->place.y;
  }
  for (int y = kLow; y <= kHigh; ++y)
    for (int x = kLow; x <= kHigh; ++x) {
      const auto inside = std::count_if(polygons.begin(), polygons.end(), [&](const Polygon& polygon) {
        return contains(polygon, {static_cast<double>(x), static_cast<double>(y)});
      });
      EXPECT_EQ(inside, expected.at(x, y) ? 1 : 0) << x << ", " << y;
    }
  std::size_t meshes = 0;
  for (const MeshRing& ring : connected_rings(region)) meshes += ring.size();
  EXPECT_GE(meshes, region.meshes());
}

void expect_booleans(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  const MeshRegion region_a = mesh_region(a, 1), region_b = mesh_region(b, 1);
  const CornerSet set_a = corners_of(a, kLow, kHigh), set_b = corners_of(b, kLow, kHigh);
  ASSERT_EQ(difference(region_a, set_a), "");
  ASSERT_EQ(difference(region_b, set_b), "");
  expect_rings(region_a, set_a);
  for (const Operation& operation : kOperations) {
    SCOPED_TRACE(operation.name);
    const CornerSet expected = together(set_a, set_b, operation.corner);
    const MeshRegion result = combined(region_a, region_b, operation.operation);
    EXPECT_EQ(difference(result, expected), "");
    expect_rings(result, expected);
    if (operation.operation == MeshOperation::kIntersection) continue;
    MeshRegion in_place = region_a;
    combine_into(in_place, region_b, operation.operation);
    EXPECT_EQ(difference(in_place, expected), "");
  }
}

TEST(MeshRegion, KnowsTheCornersInside) {
  // Corners (1..3, 1..2): Zhang's ring through the centres of the meshes is 3 by 2.
  const MeshRegion region = mesh_region({box(0.5, 0.5, 3.5, 2.5)}, 1);
  EXPECT_EQ(region.corners_inside(), 6);
  EXPECT_EQ(region.meshes(), 10U);
  ASSERT_EQ(region.row(0).size(), 4U);
  EXPECT_EQ(region.row(0)[0], (BoundaryMesh{0, kNorthEast}));
  EXPECT_EQ(region.row(0)[1], (BoundaryMesh{1, kNorthEast | kNorthWest}));
  EXPECT_EQ(region.row(1)[0], (BoundaryMesh{0, kNorthEast | kSouthEast}));
  EXPECT_EQ(region_of(region, 1), (Region{{box(0.5, 0.5, 3.5, 2.5), {}}}));
}

TEST(MeshRegion, BothTrianglesOfABowTieAreWorked) {
  const Ring bow_tie{{-6.5, -4.3}, {6.5, 4.3}, {6.5, -4.3}, {-6.5, 4.3}};
  const MeshRegion region = mesh_region({bow_tie}, 1);
  EXPECT_EQ(difference(region, corners_of({bow_tie}, kLow, kHigh)), "");
  EXPECT_EQ(region.corners_inside(), mesh_region({reversed(bow_tie)}, 1).corners_inside());
  EXPECT_GT(region.corners_inside(), 40) << "13 m · 8.6 m / 2 = 56 m²";
}

TEST(MeshRegion, TheAreaIsThatOfTheGround) {
  // A ring at 200 places on the grid: the mean of its areas is the area itself.
  std::mt19937_64 random(7);
  const Ring star = testing_meshes::random_star(random, {0, 0}, 6, 17, 0.001);
  std::uniform_real_distribution<double> off(0, 1);
  double sum = 0, worst = 0;
  constexpr int kTimes = 200;
  for (int i = 0; i < kTimes; ++i) {
    Ring moved = star;
    const Point by{off(random), off(random)};
    for (Point& p : moved) p = p + by;
    const double error = static_cast<double>(mesh_region({moved}, 1).corners_inside()) - signed_area(star);
    sum += error;
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(std::abs(sum) / kTimes, 4 * worst / std::sqrt(kTimes));
  EXPECT_LT(worst, perimeter(star) / 4) << "half a mesh along half of the boundary at the very most";
}

TEST(MeshBoolean, ApartInsideAndTheSame) {
  const std::vector<Ring> large{box(-9.5, -9.5, 9.5, 9.5)}, small{box(-2.3, -3.1, 4.2, 5.5)};
  expect_booleans(large, small);
  expect_booleans(small, large);
  expect_booleans(large, large);
  expect_booleans({box(-9.5, -9.5, -4, -4)}, {box(4, 4, 9, 9)});
  expect_booleans({}, small);
  expect_booleans(small, {});
}

TEST(MeshBoolean, QuadsThatShareAnEdgeHaveNothingInCommon) {
  const Point a{-7.3, -5.1}, b{4.4, 6.2};
  const std::vector<Ring> left{{a, b, b + Point{-5.2, 5.9}, a + Point{-6.1, 6.6}}};
  const std::vector<Ring> right{{b, a, a + Point{6.1, -6.6}, b + Point{5.2, -5.9}}};
  expect_booleans(left, right);
  EXPECT_TRUE(combined(mesh_region(left, 1), mesh_region(right, 1), MeshOperation::kIntersection).empty());
  EXPECT_EQ(region_of(combined(mesh_region(left, 1), mesh_region(right, 1), MeshOperation::kUnion), 1).size(),
            1U);
}

TEST(MeshBoolean, RunsOfCoincidentMeshesOfAllKinds) {
  const Ring comb{{-9.5, -6.5}, {9.5, -6.5}, {9.5, 4.5},   {6.5, 4.5},  {6.5, -2.5},
                  {3.5, -2.5},  {3.5, 4.5},  {0.5, 4.5},   {0.5, -2.5}, {-2.5, -2.5},
                  {-2.5, 4.5},  {-5.5, 4.5}, {-5.5, -2.5}, {-9.5, -2.5}};
  // Along the tips of the teeth, across them, between them, and round them at a distance of one mesh.
  for (const Ring& other :
       {box(-9.5, 4.5, 9.5, 8.5), box(-9.5, 1.5, 9.5, 8.5), box(-2.5, -2.5, 0.5, 4.5),
        box(-1.5, -1.5, -0.5, 3.5), box(3.5, -6.5, 6.5, -2.5), box(-6.5, -3.5, 4.5, 5.5)}) {
    SCOPED_TRACE(other[0].x + 100 * other[0].y);
    expect_booleans({comb}, {other});
    expect_booleans({other}, {comb});
  }
}

TEST(MeshBoolean, RingsThatTouchInAMesh) {
  // Two squares corner to corner, united, and taken out of a larger one: holes that touch.
  const std::vector<Ring> two{box(-4.5, -4.5, 0.5, 0.5), box(0.5, 0.5, 5.5, 5.5)};
  expect_booleans({two[0]}, {two[1]});
  expect_booleans({box(-9.5, -9.5, 9.5, 9.5)}, two);
  // Four round a hole that no side of a mesh connects with the outside.
  const std::vector<Ring> four{box(-6.5, -2.5, -1.5, 2.5), box(1.5, -2.5, 6.5, 2.5), box(-1.5, 2.5, 1.5, 6.5),
                               box(-1.5, -6.5, 1.5, -2.5)};
  expect_booleans(four, {box(-9.5, -9.5, 9.5, 9.5)});
  expect_booleans({box(-9.5, -9.5, 9.5, 9.5)}, four);
}

TEST(MeshBoolean, RandomConcavePolygonsWithHolesCornerByCorner) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    // In parts of a mesh at random, and on a coarse grid, where edges and corners often coincide.
    const double step = seed % 3 == 0 ? 0.5 : seed % 3 == 1 ? 2 : 1.0 / 1024;
    const std::vector<Ring> a = random_rings(random, 17, step), b = random_rings(random, 17, step);
    expect_booleans(a, b);
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace tramline::coverage
