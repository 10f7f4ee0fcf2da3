#include "tramline/avoidance/detour/goes_round.h"

#include <algorithm>
#include <cmath>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Coordinate of the detour across the grid. Its headings stay within a right angle of the direction along.
double across_at(const Path& path, double along) {
  const auto found = std::find_if(path.begin(), path.end(),
                                  [along](const PathSegment& segment) { return along <= segment.to.y; });
  if (found == path.end()) return path.back().to.x;
  if (found->straight()) {
    const double share = (along - found->from.y) / (found->to.y - found->from.y);
    return found->from.x + share * (found->to.x - found->from.x);
  }
  // An arc to the left is the right-hand side of its circle.
  const double up = along - centre(*found).y, r = radius(*found);
  return centre(*found).x + std::copysign(std::sqrt(std::max(0.0, (r - up) * (r + up))), found->curvature);
}

}  // namespace

bool goes_round(const TrackDetour& detour, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a.y > b.y) std::swap(a, b);
    const double from = std::max(a.y, detour.from), to = std::min(b.y, detour.to);
    if (to - from <= kSamePlace_m) continue;
    const double along = 0.5 * (from + to);
    const double across = a.x + (along - a.y) / (b.y - a.y) * (b.x - a.x);
    const double right_by = across - across_at(detour.path, along);
    if (detour.side == Passing::kLeft ? right_by > 0 : right_by < 0) return true;
  }
  return false;
}

}  // namespace tramline
