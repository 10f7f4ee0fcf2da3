#include "tramline/coverage/mesh/mesh_line.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "tramline/coverage/mesh/mesh_ring.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

/// Between places in meshes of 1 m.
MeshRing line(Point a, Point b) {
  MeshRing out;
  append_mesh_line(fine_point(a, 1), fine_point(b, 1), out);
  return out;
}

/// What Zhang finds when its line is drawn from the other end.
MeshRing line_back(Point a, Point b) {
  MeshRing out = line(b, a);
  std::reverse(out.begin(), out.end());
  return out;
}

void expect_line(Point a, Point b, const MeshRing& meshes) {
  EXPECT_EQ(line(a, b), meshes);
  EXPECT_EQ(line_back(a, b), meshes);
}

TEST(MeshLine, AlongTheAxes) {
  expect_line({0.5, 0.5}, {3.2, 0.5}, {{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  expect_line({0.5, 0.5}, {0.5, -1.5}, {{0, 0}, {0, -1}, {0, -2}});
  expect_line({0.2, 0.1}, {0.9, 0.8}, {{0, 0}});
}

TEST(MeshLine, ALineOfTheGridBelongsToTheMeshesAboveItAndToTheRight) {
  expect_line({0, 2}, {3, 2}, {{0, 2}, {1, 2}, {2, 2}, {3, 2}});
  expect_line({2, 0}, {2, 2}, {{2, 0}, {2, 1}, {2, 2}});
  expect_line({-1, -1}, {-2, -1}, {{-1, -1}, {-2, -1}});
}

TEST(MeshLine, TwoAndThreeOfFourMeshesTogether) {
  // y = x/2 + 0.6: leaves column 0 at 1.1, column 1 at 1.6, column 2 at 2.1.
  expect_line({0, 0.6}, {3, 2.1}, {{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 2}, {3, 2}});
  // falling with the same slope: 2.9, 2.4, 1.9
  expect_line({0, 3.4}, {3, 1.9}, {{0, 3}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {3, 1}});
}

TEST(MeshLine, SteepLines) {
  // x = 0.7 + y/4 reaches column 1 at y = 1.2.
  expect_line({0.7, 0}, {1.4, 2.8}, {{0, 0}, {0, 1}, {1, 1}, {1, 2}});
  expect_line({0.7, 0}, {1.4, -2.8}, {{0, 0}, {0, -1}, {0, -2}, {1, -2}, {1, -3}});
}

TEST(MeshLine, ThroughCornersOfTheGridByTheUpperMesh) {
  expect_line({0.5, 0.5}, {2.5, 2.5}, {{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}});
  expect_line({0.5, 2.5}, {2.5, 0.5}, {{0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}});
  expect_line({0.5, 0}, {1.5, 2}, {{0, 0}, {0, 1}, {1, 1}, {1, 2}});
}

TEST(MeshLine, GoesOnFromTheMeshItBeginsIn) {
  MeshRing out = line({0.5, 0.5}, {1.5, 0.5});
  append_mesh_line(fine_point({1.5, 0.5}, 1), fine_point({1.5, 1.5}, 1), out);
  EXPECT_EQ(out, (MeshRing{{0, 0}, {1, 0}, {1, 1}}));
}

TEST(MeshLine, ScaleIsTheSideOfAMesh) {
  EXPECT_EQ(mesh_at(fine_point({1.02, -0.01}, 0.05)), (Mesh{20, -1}));
  EXPECT_EQ(mesh_at(fine_point({1.02, -0.01}, 0.02)), (Mesh{51, -1}));
  EXPECT_EQ(mesh_at(fine_point({0.15, 5 + 1e-13}, 0.05)), mesh_at(fine_point({0.15, 5 - 1e-13}, 0.05)))
      << "a line of the grid, to rounding";
}

TEST(MeshLine, WhatMeshesDoNotReachIsRefused) {
  EXPECT_REFUSED(fine_point({1e6, 0}, 0.05));
  EXPECT_REFUSED(fine_point({0, std::nan("")}, 0.05));
  EXPECT_NO_THROW(fine_point({5e4, -5e4}, 0.05));
}

/// Twice the area of the triangle a, b and a corner of the grid, in fine units.
std::int64_t side_of(FinePoint a, FinePoint b, std::int64_t x, std::int64_t y) {
  return (b.x - a.x) * (y * kFinePerMesh - a.y) - (b.y - a.y) * (x * kFinePerMesh - a.x);
}

/// Whether the line passes through the inside of the square (`touch`: or its border).
bool meets(FinePoint a, FinePoint b, Mesh mesh, bool touch) {
  const std::int64_t west = mesh.x * kFinePerMesh, south = mesh.y * kFinePerMesh;
  const std::int64_t margin = touch ? 1 : 0;
  if (std::max(a.x, b.x) <= west - margin || std::min(a.x, b.x) >= west + kFinePerMesh + margin) return false;
  if (std::max(a.y, b.y) <= south - margin || std::min(a.y, b.y) >= south + kFinePerMesh + margin)
    return false;
  int left = 0, right = 0;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const std::int64_t side = side_of(a, b, mesh.x + i, mesh.y + j);
      left += side > 0 || (touch && side == 0) ? 1 : 0;
      right += side < 0 || (touch && side == 0) ? 1 : 0;
    }
  return left > 0 && right > 0;
}

TEST(MeshLine, FindsEveryMeshThatALineCutsAndNoneThatItDoesNotReach) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::int64_t step = seed % 2 == 0 ? 1 : kFinePerMesh / 4;  // the latter passes through many corners
    std::uniform_int_distribution<std::int64_t> place(-12 * kFinePerMesh / step, 12 * kFinePerMesh / step);
    const auto any = [&] { return FinePoint{step * place(random), step * place(random)}; };
    const FinePoint a = any(), b = any();
    MeshRing meshes;
    append_mesh_line(a, b, meshes);
    ASSERT_EQ(meshes.front(), mesh_at(a));
    ASSERT_EQ(meshes.back(), mesh_at(b));
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      EXPECT_TRUE(meets(a, b, meshes[i], true));
      EXPECT_EQ(std::count(meshes.begin(), meshes.end(), meshes[i]), 1);
      if (i == 0) continue;
      EXPECT_EQ(std::abs(meshes[i].x - meshes[i - 1].x) + std::abs(meshes[i].y - meshes[i - 1].y), 1);
    }
    for (int y = -13; y <= 13; ++y)
      for (int x = -13; x <= 13; ++x) {
        if (!meets(a, b, {x, y}, false)) continue;
        EXPECT_EQ(std::count(meshes.begin(), meshes.end(), Mesh{x, y}), 1) << x << ", " << y;
      }
  }
}

TEST(MeshRing, OfASquare) {
  EXPECT_EQ(mesh_ring({{0.5, 0.5}, {2.5, 0.5}, {2.5, 1.5}, {0.5, 1.5}}, 1),
            (MeshRing{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}));
}

TEST(MeshRing, ExcursionsAreLeftOut) {
  // A needle to the right of the square, less than a mesh wide, and its like across the ring's first mesh.
  const MeshRing square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  EXPECT_EQ(
      mesh_ring({{0.5, 0.5}, {2.5, 0.5}, {2.5, 1.4}, {5.5, 1.5}, {2.5, 1.6}, {2.5, 2.5}, {0.5, 2.5}}, 1),
      square);
  MeshRing needle_first =
      mesh_ring({{-4.5, 0.5}, {0.5, 0.4}, {2.5, 0.4}, {2.5, 2.5}, {0.5, 2.5}, {0.5, 0.6}}, 1);
  std::rotate(needle_first.begin(), std::find(needle_first.begin(), needle_first.end(), Mesh{0, 0}),
              needle_first.end());
  EXPECT_EQ(needle_first, square);
  EXPECT_TRUE(mesh_ring({{0.5, 0.5}, {9.5, 0.5}, {5, 0.8}}, 1).empty()) << "nothing but a needle";
}

}  // namespace
}  // namespace tramline::coverage
