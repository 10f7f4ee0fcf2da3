#pragma once
// The meshes that a line passes through (Zhang §2.3.2).

#include <cstdint>
#include <vector>

#include "tramline/coverage/mesh/mesh.h"

namespace tramline::coverage {

/// Coordinates are rounded to this part of a mesh, so that edges meant to lie on a grid line do, and all
/// further computation is in integers.
inline constexpr std::int64_t kFinePerMesh = 1024;
/// Largest coordinate, in meshes: 52 km at 0.05 m.
inline constexpr std::int64_t kFarthestMesh = 1 << 20;

/// A point in parts of a mesh.
struct FinePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Throws Error(kBadInput) beyond kFarthestMesh, and for NaN.
FinePoint fine_point(Point p, double mesh_m);

/// The mesh a point lies in. On a line of the grid: the one to the right of it, or above it.
Mesh mesh_at(FinePoint p);

/// Appends the meshes that a line from a to b passes through, in order and both ends included; the first one
/// is left out if `out` ends with it.
///
/// Every mesh has a side in common with the one before. Zhang grows meshes along the axis along which there
/// are more of them; going along columns, and up and down within each, finds the same. Where the line passes
/// through a corner of the grid, Zhang finds two meshes that only touch there (fig. 4, E to J) and inserts
/// one of the other two afterwards: here the upper one. A line and its reverse pass through the same meshes,
/// and two lines that do not cross have meshes that do not cross. O(meshes).
void append_mesh_line(FinePoint a, FinePoint b, std::vector<Mesh>& out);

}  // namespace tramline::coverage
