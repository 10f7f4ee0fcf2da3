#include "tramline/coverage/mesh/mesh_region.h"

#include <algorithm>
#include <utility>

namespace tramline::coverage {
namespace {

/// A mesh of a ring, and how the winding number changes from its upper left to its upper right corner.
struct Passage {
  Mesh mesh;
  int change = 0;
};

/// Ordered by rows, and along them.
struct Before {
  bool operator()(const Passage& a, const Passage& b) const {
    return a.mesh.y != b.mesh.y ? a.mesh.y < b.mesh.y : a.mesh.x < b.mesh.x;
  }
};

void append_passages(const MeshRing& ring, std::vector<Passage>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Mesh mesh = ring[i], next = ring[i + 1 < ring.size() ? i + 1 : 0];
    out.push_back({mesh, next.y > mesh.y ? -1 : 0});
    if (next.y < mesh.y) out.push_back({next, 1});
  }
}

/// One for each mesh, ordered.
std::vector<Passage> merged(std::vector<Passage> passages) {
  std::sort(passages.begin(), passages.end(), Before{});
  std::size_t kept = 0;
  for (const Passage& passage : passages) {
    if (kept > 0 && passages[kept - 1].mesh == passage.mesh)
      passages[kept - 1].change += passage.change;
    else
      passages[kept++] = passage;
  }
  passages.resize(kept);
  return passages;
}

/// Corners inside of the meshes of one row. Every change of the row below is at a mesh of this row too.
MeshRow corners_of_row(std::span<const Passage> below, std::span<const Passage> row) {
  MeshRow out;
  int north = 0, south = 0;  // winding numbers
  auto lower = below.begin();
  for (const Passage& passage : row) {
    unsigned inside = (north != 0 ? kNorthWest : 0U) | (south != 0 ? kSouthWest : 0U);
    while (lower != below.end() && lower->mesh.x < passage.mesh.x) ++lower;
    if (lower != below.end() && lower->mesh.x == passage.mesh.x) south += lower->change;
    north += passage.change;
    inside |= (north != 0 ? kNorthEast : 0U) | (south != 0 ? kSouthEast : 0U);
    if (inside != kNoCorner && inside != kAllCorners)
      out.push_back({passage.mesh.x, static_cast<Corners>(inside)});
  }
  return out;
}

/// What the meshes of a row say of the corners above them: each stretch inside counts its end less its begin.
std::int64_t corners_above(std::span<const BoundaryMesh> row) {
  std::int64_t out = 0;
  for (const BoundaryMesh& mesh : row) {
    const bool west = (mesh.inside & kNorthWest) != 0, east = (mesh.inside & kNorthEast) != 0;
    out += (static_cast<int>(west) - static_cast<int>(east)) * std::int64_t{mesh.x};
  }
  return out;
}

}  // namespace

std::span<const BoundaryMesh> MeshRegion::row(int y) const {
  if (y < first_row_ || y >= end_row()) return {};
  return rows_[static_cast<std::size_t>(y - first_row_)];
}

MeshRow& MeshRegion::row_at(int y) {
  if (rows_.empty()) first_row_ = y;
  if (y < first_row_) {
    // More than is needed, so that a drive towards smaller y does not move all rows at every step.
    const auto more = std::max(static_cast<std::size_t>(first_row_ - y), rows_.size() / 2);
    rows_.insert(rows_.begin(), more, {});
    first_row_ -= static_cast<int>(more);
  }
  if (y >= end_row()) rows_.resize(static_cast<std::size_t>(y - first_row_) + 1);
  return rows_[static_cast<std::size_t>(y - first_row_)];
}

void MeshRegion::replace(int y, std::size_t from, std::size_t to, std::span<const BoundaryMesh> meshes) {
  MeshRow& row = row_at(y);
  corners_ += corners_above(meshes) - corners_above(std::span(row).subspan(from, to - from));
  meshes_ = meshes_ + meshes.size() - (to - from);
  const auto begin = row.begin() + static_cast<std::ptrdiff_t>(from);
  const std::size_t same = std::min(to - from, meshes.size());
  const auto split = std::copy_n(meshes.begin(), same, begin);
  if (same < meshes.size())
    row.insert(split, meshes.begin() + static_cast<std::ptrdiff_t>(same), meshes.end());
  else
    row.erase(split, row.begin() + static_cast<std::ptrdiff_t>(to));
}

MeshRegion mesh_region(const std::vector<Ring>& rings, double mesh_m) {
  std::vector<Passage> passages;
  for (const Ring& ring : rings) append_passages(mesh_ring(ring, mesh_m), passages);
  passages = merged(std::move(passages));
  MeshRegion out;
  std::span<const Passage> below;
  for (std::size_t begin = 0, end = 0; begin < passages.size(); begin = end) {
    while (end < passages.size() && passages[end].mesh.y == passages[begin].mesh.y) ++end;
    const auto row = std::span<const Passage>(passages).subspan(begin, end - begin);
    const int y = row.front().mesh.y;
    if (!below.empty() && below.front().mesh.y != y - 1) below = {};
    if (const MeshRow meshes = corners_of_row(below, row); !meshes.empty()) out.replace(y, 0, 0, meshes);
    below = row;
  }
  return out;
}

std::size_t lower_mesh(std::span<const BoundaryMesh> row, std::int32_t x) {
  const auto found = std::lower_bound(
      row.begin(), row.end(), x, [](const BoundaryMesh& mesh, std::int32_t value) { return mesh.x < value; });
  return static_cast<std::size_t>(found - row.begin());
}

}  // namespace tramline::coverage
