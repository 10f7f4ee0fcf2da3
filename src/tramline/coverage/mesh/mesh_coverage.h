#pragma once
// The coverage engine described by Zhang: boundaries as meshes of a grid.

#include <cstddef>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/mesh/mesh_region.h"
#include "tramline/coverage/mesh/mesh_tiles.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// d_g of Zhang §2.3.1, m.
inline constexpr double kMesh_m = 0.05;
inline constexpr double kFineMesh_m = 0.02;
/// Side of a tile where the machine is not known.
inline constexpr double kMeshTile_m = 8;

/// Areas and regions of what was worked, to the resolution of a mesh (Zhang §3.1).
/// Coverage is the union of all quads. The intersection of a quad with the coverage before it is repeated:
/// quads that share a bar share meshes, but no area. Leakage, here missed land, is the residual of the
/// coverage in the field. Zhang §3.2 computes it anew at every point, which is what makes it slow there; here
/// every quad is subtracted from it, which gives the same region, as operations on corners are exact.
/// Limitations: it does not know whether land was worked again by the machine's own trail, so repeated_m2 is
/// all land worked twice and sliver_m2 is 0; and it does not know whether land was worked more than twice:
/// worked_times_m2[2] and [3] are NaN. Areas are those of rings through the centres of meshes.
class MeshCoverage {
 public:
  /// `field`: without obstacles, oriented; empty: no field. `tile_m`: about the side of tiles(). Throws
  /// Error(kBadInput) where mesh_m is not positive, and for coordinates beyond the range of meshes
  /// (mesh/mesh_line.h).
  MeshCoverage(const Region& field, double mesh_m, double tile_m = kMeshTile_m);

  /// O(meshes of the quads, and of the regions beside them), with logarithms and row moves.
  /// Throws Error(kBadInput) for coordinates beyond the range of meshes; earlier work is then kept.
  void add(const WorkedStep& step);

  /// Adds land that may have been worked and was not recorded. Throws as add() does.
  void add_unrecorded(const std::vector<Quad>& quads);

  /// O(1).
  CoverageAreas areas() const;
  /// O(1).
  Meshes meshes() const;

  /// All land of this class: rings through centres of meshes, simple, holes inside. O(meshes log meshes).
  /// Throws Error(kBadInput) for land worked exactly twice or more often, which is not counted here.
  Region region(LandClass what) const;

  double mesh_m() const { return mesh_m_; }
  const MeshRegion& covered() const { return coverage_; }
  const MeshRegion& repeated() const { return repeated_; }
  /// The field less coverage and unrecorded land.
  const MeshRegion& missed() const { return missed_; }

  /// The tiles in which covered or repeated land changed.
  const MeshTiles& tiles() const { return tiles_; }

 private:
  bool has_field() const { return field_.corners_inside() > 0; }
  double area_m2(const MeshRegion& region) const;
  void count_meshes();

  double mesh_m_;
  MeshRegion field_;
  MeshRegion coverage_;
  MeshRegion repeated_;
  MeshRegion missed_;
  MeshRegion unrecorded_;  ///< less coverage; within the field where there is one
  MeshTiles tiles_;
  std::size_t most_covered_ = 0;  ///< meshes
  std::size_t most_missed_ = 0;
  std::int64_t gross_corners_ = 0;
};

}  // namespace tramline::coverage
