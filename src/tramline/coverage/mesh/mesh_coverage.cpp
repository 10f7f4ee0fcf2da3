#include "tramline/coverage/mesh/mesh_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/coverage/mesh/connected_rings.h"
#include "tramline/coverage/mesh/mesh_boolean.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

double checked(double mesh_m) {
  if (!(mesh_m > 0) || mesh_m == std::numeric_limits<double>::infinity())
    throw bad_input(fmt::format("meshes of {} m: give a side greater than 0, such as {}", mesh_m, kMesh_m));
  return mesh_m;
}

double area_of(std::int64_t corners, double mesh_m) { return static_cast<double>(corners) * mesh_m * mesh_m; }

}  // namespace

MeshCoverage::MeshCoverage(const Region& field, double mesh_m, double tile_m)
    : mesh_m_(checked(mesh_m)),
      field_(mesh_region(rings_of(field), mesh_m)),
      missed_(field_),
      tiles_(std::max(1, static_cast<int>(std::lround(tile_m / mesh_m)))) {
  count_meshes();
}

void MeshCoverage::count_meshes() {
  most_covered_ = std::max(most_covered_, coverage_.meshes());
  most_missed_ = std::max(most_missed_, missed_.meshes());
}

Meshes MeshCoverage::meshes() const {
  return {mesh_m_, {coverage_.meshes(), most_covered_}, {missed_.meshes(), most_missed_}};
}

void MeshCoverage::add(const WorkedStep& step) {
  std::vector<MeshRegion> quads;
  for (const Quad& quad : step.quads) quads.push_back(mesh_region({Ring(quad.begin(), quad.end())}, mesh_m_));
  for (const MeshRegion& quad : quads) {
    gross_corners_ += quad.corners_inside();
    combine_into(repeated_, combined(coverage_, quad, MeshOperation::kIntersection), MeshOperation::kUnion);
    combine_into(coverage_, quad, MeshOperation::kUnion);
    combine_into(missed_, quad, MeshOperation::kResidual);
    combine_into(unrecorded_, quad, MeshOperation::kResidual);
    tiles_.touch(quad);
  }
  tiles_.end_step();
  count_meshes();
}

void MeshCoverage::add_unrecorded(const std::vector<Quad>& quads) {
  for (const Quad& quad : quads) {
    MeshRegion open =
        combined(mesh_region({Ring(quad.begin(), quad.end())}, mesh_m_), coverage_, MeshOperation::kResidual);
    if (has_field()) open = combined(open, field_, MeshOperation::kIntersection);
    combine_into(unrecorded_, open, MeshOperation::kUnion);
    combine_into(missed_, open, MeshOperation::kResidual);
  }
  count_meshes();
}

double MeshCoverage::area_m2(const MeshRegion& region) const {
  return area_of(region.corners_inside(), mesh_m_);
}

CoverageAreas MeshCoverage::areas() const {
  const std::int64_t not_recorded = unrecorded_.corners_inside();
  const std::int64_t not_covered = has_field() ? missed_.corners_inside() + not_recorded : 0;
  const std::int64_t inside = field_.corners_inside() - not_covered;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  CoverageAreas out;
  out.gross_m2 = area_of(gross_corners_, mesh_m_);
  out.covered_m2 = area_m2(coverage_);
  out.covered_inside_m2 = area_of(inside, mesh_m_);
  out.outside_m2 = area_of(coverage_.corners_inside() - inside, mesh_m_);
  out.repeated_m2 = area_m2(repeated_);
  out.missed_m2 = area_m2(missed_);
  out.not_recorded_m2 = area_of(not_recorded, mesh_m_);
  const std::int64_t once = coverage_.corners_inside() - repeated_.corners_inside();
  out.worked_times_m2 = {area_of(not_covered, mesh_m_), area_of(once, mesh_m_), unknown, unknown};
  return out;
}

Region MeshCoverage::region(LandClass what) const {
  switch (what) {
    case LandClass::kCovered:
      return region_of(coverage_, mesh_m_);
    case LandClass::kRepeated:
    case LandClass::kAgain:
      return region_of(repeated_, mesh_m_);
    case LandClass::kSliver:
      return {};
    case LandClass::kMissed:
      return region_of(missed_, mesh_m_);
    case LandClass::kUnrecorded:
      return region_of(unrecorded_, mesh_m_);
    case LandClass::kOutside:
      return region_of(combined(coverage_, field_, MeshOperation::kResidual), mesh_m_);
    case LandClass::kOnce:
      return region_of(combined(coverage_, repeated_, MeshOperation::kResidual), mesh_m_);
    case LandClass::kTwice:
    case LandClass::kOften:
      break;
  }
  throw bad_input(
      "the mesh engine tells land worked once from land worked again, but not how often it was worked; use "
      "the exact engine");
}

}  // namespace tramline::coverage
