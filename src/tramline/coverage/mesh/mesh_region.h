#pragma once
// A region stored as the meshes of its boundary.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tramline/coverage/mesh/mesh_ring.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The meshes of one row, by growing x.
using MeshRow = std::vector<BoundaryMesh>;

/// A region of any number of rings, known by the meshes that its boundary runs through; each of them knows
/// which of its corners lie inside. Rings through the centres of the meshes, as Zhang has them, enclose just
/// these corners, so that an area is the number of corners inside times the area of a mesh.
class MeshRegion {
 public:
  int first_row() const { return first_row_; }
  int end_row() const { return first_row_ + static_cast<int>(rows_.size()); }
  std::span<const BoundaryMesh> row(int y) const;  ///< empty outside the rows

  bool empty() const { return meshes_ == 0; }
  std::size_t meshes() const { return meshes_; }            ///< on the boundary
  std::int64_t corners_inside() const { return corners_; }  ///< of the grid

  /// Replaces the meshes [from, to) of a row by others; rows are added as needed. O(row). Precondition: the
  /// row stays ordered, and when all rows are done, rows agree about the corners between.
  void replace(int y, std::size_t from, std::size_t to, std::span<const BoundaryMesh> meshes);

 private:
  MeshRow& row_at(int y);

  int first_row_ = 0;
  std::vector<MeshRow> rows_;
  std::size_t meshes_ = 0;
  std::int64_t corners_ = 0;
};

/// The region that rings enclose, corners with a winding number other than 0: polygons with their holes,
/// oriented, and both triangles of a bow-tie. Throws as fine_point(). O(n log n) for n meshes.
MeshRegion mesh_region(const std::vector<Ring>& rings, double mesh_m);

/// Index of the first mesh of a row at or after x. O(log n).
std::size_t lower_mesh(std::span<const BoundaryMesh> row, std::int32_t x);

/// Whether the corners after meshes [0, index) of a row lie inside, that is, those of every mesh from there
/// to mesh `index`, which the boundary does not run through.
inline bool inside_before(std::span<const BoundaryMesh> row, std::size_t index) {
  return index > 0 && (row[index - 1].inside & kNorthEast) != 0;
}

}  // namespace tramline::coverage
