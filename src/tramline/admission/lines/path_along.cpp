#include "tramline/admission/lines/path_along.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "tramline/geometry/point.h"

namespace tramline {
namespace {

/// Whether the vertices lie near the other line's edges, in its order. The first edge near enough is taken:
/// where any order of edges is possible, that is.
bool follows(const std::vector<Point>& vertices, const std::vector<Point>& line, double within_m) {
  std::size_t edge = 0;
  for (const Point p : vertices) {
    while (edge + 1 < line.size() && distance_to_segment(p, line[edge], line[edge + 1]) > within_m) ++edge;
    if (edge + 1 >= line.size()) return false;
  }
  return true;
}

bool runs_along(const std::vector<Point>& path, const std::vector<Point>& line, double within_m) {
  return distance(path.front(), line.front()) <= within_m && distance(path.back(), line.back()) <= within_m &&
         follows(line, path, within_m) && follows(path, line, within_m);
}

}  // namespace

std::optional<Path> path_along(const Path& path, const std::vector<Point>& line, double within_m) {
  assert(!path.empty() && !line.empty());
  // Chords off by a small share of what is allowed.
  constexpr double kShare = 0.01;
  const double sagitta_m = std::max(kChordSagitta, kShare * within_m);
  std::vector<Point> points = chords(path, sagitta_m);
  if (runs_along(points, line, within_m + sagitta_m)) return path;
  std::reverse(points.begin(), points.end());
  if (runs_along(points, line, within_m + sagitta_m)) return reversed(path);
  return std::nullopt;
}

}  // namespace tramline
