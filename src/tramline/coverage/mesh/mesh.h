#pragma once
// Meshes: the squares of a grid over the plane (Zhang §2.3.1), and their data on a region.

#include <compare>
#include <cstdint>

#include "tramline/geometry/point.h"

namespace tramline::coverage {

/// The square [x, x + 1) × [y, y + 1), in sides of a mesh: Zhang eq. 5 without the factor d_g.
struct Mesh {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(Mesh a, Mesh b) = default;
};

/// Which of the corners of a mesh lie inside a region, as a set of bits.
using Corners = std::uint8_t;
inline constexpr Corners kNorthEast = 1, kNorthWest = 2, kSouthWest = 4, kSouthEast = 8;
inline constexpr Corners kNoCorner = 0, kAllCorners = 15;

/// A mesh that the boundary of a region runs through: some of its corners lie inside and some outside.
struct BoundaryMesh {
  std::int32_t x = 0;
  Corners inside = kNoCorner;

  friend constexpr bool operator==(BoundaryMesh a, BoundaryMesh b) = default;
};

/// The centre of a mesh, m: a vertex of Zhang's regions.
constexpr Point centre(Mesh mesh, double mesh_m) {
  return {(mesh.x + 0.5) * mesh_m, (mesh.y + 0.5) * mesh_m};
}

}  // namespace tramline::coverage
