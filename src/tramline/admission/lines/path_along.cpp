#include "tramline/admission/lines/path_along.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "tramline/geometry/point.h"

namespace tramline {
namespace {

/// Whether the vertices lie near the other line, in its order: each goes to the first point of the line that
/// is near enough and not behind that of the vertex before it. Where any such points exist, these do.
bool follows(const std::vector<Point>& vertices, const std::vector<Point>& line, double within_m) {
  std::size_t edge = 0;
  double reached_m = 0;  // along that edge
  for (const Point p : vertices) {
    for (;; ++edge, reached_m = 0) {
      if (edge + 1 >= line.size()) return false;
      const Point from = line[edge], to = line[edge + 1];
      if (distance_to_segment(p, from, to) > within_m) continue;
      const double length_m = distance(from, to);
      if (length_m == 0) break;
      const Point unit = (1 / length_m) * (to - from);
      const double foot_m = dot(p - from, unit), off_m = cross(unit, p - from);
      const double reach_m = std::sqrt(std::max(0.0, within_m * within_m - off_m * off_m));
      if (foot_m + reach_m < reached_m) continue;
      reached_m = std::max(reached_m, foot_m - reach_m);
      break;
    }
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
