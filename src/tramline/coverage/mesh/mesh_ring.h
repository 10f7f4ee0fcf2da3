#pragma once
// The boundary of a polygon as a sequence of meshes (Zhang §2.3).

#include <vector>

#include "tramline/coverage/mesh/mesh_line.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// Meshes in the order in which a boundary runs through them, each with a side in common with the next, the
/// last with the first.
using MeshRing = std::vector<Mesh>;

/// The meshes that a ring passes through, cleaned up: no mesh follows itself, and where the sequence turns
/// back on itself (in a mesh, and out through the side it came in by), that excursion is left out, as it
/// encloses nothing. A ring that encloses no corner of a mesh in this way may be left with no mesh at all.
/// Throws as fine_point(). O(meshes).
MeshRing mesh_ring(const Ring& ring, double mesh_m);

}  // namespace tramline::coverage
