#pragma once
// Union, intersection and residual of regions (Zhang §2.4 and §2.5).

#include "tramline/coverage/mesh/mesh_region.h"

namespace tramline::coverage {

enum class MeshOperation {
  kUnion,
  kIntersection,
  kResidual,  ///< of the second region in the first: the first less the second
};

/// Every mesh of either boundary is classified against the other region (Zhang §2.4). One that is in both
/// boundaries is coincident; any other lies wholly inside or outside the other region, as determined by the
/// last mesh before it in its row. Corner by corner the operation then says what the result is there: the
/// mesh is valid where that leaves corners inside and outside, and belongs to the result's boundary; else
/// invalid.
///
/// Zhang deletes and connects overlapping meshes (the ends of coincident runs) by tables of cases of the
/// neighbours along both sequences, one pair of runs at a time; the tables do not cover boundaries that meet
/// in more than that, runs of one mesh, or rings that touch themselves. The corners of the coincident mesh
/// give the same result in every case. The result is exactly that of the operation on the corners inside.

/// O(meshes of the two).
MeshRegion combined(const MeshRegion& a, const MeshRegion& b, MeshOperation operation);

/// a becomes a united with b, or less b. Only the meshes of a that lie between the first and the last mesh of
/// b in a row are looked at. O(rows of b · log a + meshes looked at). Precondition: no intersection.
void combine_into(MeshRegion& a, const MeshRegion& b, MeshOperation operation);

}  // namespace tramline::coverage
