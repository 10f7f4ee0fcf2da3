#include "tramline/coverage/mesh/mesh_boolean.h"

#include <algorithm>

namespace tramline::coverage {
namespace {

constexpr Corners together(Corners a, Corners b, MeshOperation operation) {
  switch (operation) {
    case MeshOperation::kUnion:
      return a | b;
    case MeshOperation::kIntersection:
      return a & b;
    case MeshOperation::kResidual:
      break;
  }
  return a & static_cast<Corners>(~b & kAllCorners);
}

constexpr Corners all_or_none(bool inside) { return inside ? kAllCorners : kNoCorner; }

/// Meshes [from, to) of a row.
struct Stretch {
  std::span<const BoundaryMesh> row;
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Goes along a stretch, and tells of any mesh which of its corners lie inside.
class Reader {
 public:
  explicit Reader(const Stretch& stretch)
      : next_(stretch.row.begin() + static_cast<std::ptrdiff_t>(stretch.from)),
        end_(stretch.row.begin() + static_cast<std::ptrdiff_t>(stretch.to)),
        inside_(inside_before(stretch.row, stretch.from)) {}

  bool done() const { return next_ == end_; }
  std::int32_t x() const { return next_->x; }
  Corners corners_at(std::int32_t x) {
    if (done() || next_->x != x) return all_or_none(inside_);
    const Corners out = next_->inside;
    inside_ = (out & kNorthEast) != 0;
    ++next_;
    return out;
  }

 private:
  std::span<const BoundaryMesh>::iterator next_, end_;
  bool inside_;
};

void append_combined(const Stretch& a, const Stretch& b, MeshOperation operation, MeshRow& out) {
  Reader first(a), second(b);
  while (!first.done() || !second.done()) {
    const bool from_first = second.done() || (!first.done() && first.x() <= second.x());
    const std::int32_t x = from_first ? first.x() : second.x();
    const Corners of_first = first.corners_at(x), of_second = second.corners_at(x);
    const Corners inside = together(of_first, of_second, operation);
    if (inside != kNoCorner && inside != kAllCorners) out.push_back({x, inside});
  }
}

/// The meshes between the first and the last of another row.
Stretch beside(std::span<const BoundaryMesh> row, std::span<const BoundaryMesh> other) {
  return {row, lower_mesh(row, other.front().x), lower_mesh(row, other.back().x + 1)};
}

Stretch whole(std::span<const BoundaryMesh> row) { return {row, 0, row.size()}; }

}  // namespace

MeshRegion combined(const MeshRegion& a, const MeshRegion& b, MeshOperation operation) {
  int first = a.first_row(), end = a.end_row();
  if (operation == MeshOperation::kUnion && !b.empty()) {
    first = a.empty() ? b.first_row() : std::min(first, b.first_row());
    end = a.empty() ? b.end_row() : std::max(end, b.end_row());
  } else if (operation == MeshOperation::kIntersection) {
    first = std::max(first, b.first_row());
    end = std::min(end, b.end_row());
  }
  MeshRegion out;
  MeshRow meshes;
  for (int y = first; y < end; ++y) {
    const auto row_a = a.row(y), row_b = b.row(y);
    const bool beside_only = operation == MeshOperation::kIntersection;
    if (beside_only && (row_a.empty() || row_b.empty())) continue;
    meshes.clear();
    append_combined(beside_only ? beside(row_a, row_b) : whole(row_a), whole(row_b), operation, meshes);
    if (!meshes.empty()) out.replace(y, 0, 0, meshes);
  }
  return out;
}

void combine_into(MeshRegion& a, const MeshRegion& b, MeshOperation operation) {
  MeshRow meshes;
  for (int y = b.first_row(); y < b.end_row(); ++y) {
    const auto row = b.row(y);
    if (row.empty()) continue;
    if (operation == MeshOperation::kResidual && a.row(y).empty()) continue;  // nothing to take from
    const Stretch near = beside(a.row(y), row);
    meshes.clear();
    append_combined(near, whole(row), operation, meshes);
    a.replace(y, near.from, near.to, meshes);
  }
}

}  // namespace tramline::coverage
