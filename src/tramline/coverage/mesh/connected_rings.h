#pragma once
// Connects the meshes of a boundary to rings (Zhang §2.5).

#include <vector>

#include "tramline/coverage/mesh/mesh_region.h"

namespace tramline::coverage {

/// The rings of a region: counter-clockwise round its inside, clockwise round holes. No ring passes through a
/// mesh twice; two may touch in one.
///
/// From each mesh the boundary goes on to the neighbour behind the side whose corners differ, the corner
/// inside on its left. Where a mesh has two opposite corners inside, it turns left, so that they are not
/// connected there. Zhang's rules for general, dual, additional and special segments have the same result.
/// In the order of the rings' lowest leftmost meshes. O(n log n) for n meshes.
std::vector<MeshRing> connected_rings(const MeshRegion& region);

/// The same as polygons through the centres of the meshes, m; meshes on a straight line with both neighbours
/// are left out, which does not change the area. O(n log n + rings²).
Region region_of(const MeshRegion& region, double mesh_m);

}  // namespace tramline::coverage
