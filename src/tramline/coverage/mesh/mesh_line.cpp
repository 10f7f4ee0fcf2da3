#include "tramline/coverage/mesh/mesh_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - static_cast<std::int64_t>(a % b != 0 && (a < 0) != (b < 0));
}

void append_column(std::int32_t x, std::int32_t from, std::int32_t to, std::vector<Mesh>& out) {
  const std::int32_t growth = to < from ? -1 : 1;  // Zhang eq. 8
  for (std::int32_t y = from; y != to + growth; y += growth) out.push_back({x, y});
}

}  // namespace

FinePoint fine_point(Point p, double mesh_m) {
  const auto most = static_cast<double>(kFarthestMesh);
  const Point q = (1 / mesh_m) * p;
  if (!(std::abs(q.x) < most && std::abs(q.y) < most))
    throw bad_input(
        fmt::format("the place ({}, {}) is further than {} m from the origin: meshes of {} m do not "
                    "reach it; use larger ones",
                    p.x, p.y, most * mesh_m, mesh_m));
  return {std::llround(q.x * kFinePerMesh), std::llround(q.y * kFinePerMesh)};
}

Mesh mesh_at(FinePoint p) {
  return {static_cast<std::int32_t>(floor_div(p.x, kFinePerMesh)),
          static_cast<std::int32_t>(floor_div(p.y, kFinePerMesh))};
}

void append_mesh_line(FinePoint a, FinePoint b, std::vector<Mesh>& out) {
  const bool backwards = b.x < a.x;
  if (backwards) std::swap(a, b);
  const Mesh first = mesh_at(a), last = mesh_at(b);
  const std::size_t known = out.size();
  std::int32_t y = first.y;
  for (std::int32_t x = first.x; x < last.x; ++x) {
    // Where it leaves the column. A corner of the grid belongs to the mesh above and to the right of it.
    const std::int64_t along = (x + 1) * kFinePerMesh - a.x;
    const std::int64_t height = a.y + floor_div(along * (b.y - a.y), b.x - a.x);
    const auto leaves = static_cast<std::int32_t>(floor_div(height, kFinePerMesh));
    append_column(x, y, leaves, out);
    y = leaves;
  }
  append_column(last.x, y, last.y, out);
  const auto added = out.begin() + static_cast<std::ptrdiff_t>(known);
  if (backwards) std::reverse(added, out.end());
  if (known > 0 && out[known - 1] == out[known]) out.erase(out.begin() + static_cast<std::ptrdiff_t>(known));
}

}  // namespace tramline::coverage
