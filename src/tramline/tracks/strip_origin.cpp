#include "tramline/tracks/strip_origin.h"

#include <algorithm>

#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

struct ParallelEdge {
  double length;
  double across;
};

void append_parallel_edges(const Ring& turned, std::vector<ParallelEdge>& out) {
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Point a = turned[i], b = turned[i + 1 == turned.size() ? 0 : i + 1];
    const double length = std::abs(b.y - a.y);
    if (std::abs(b.x - a.x) <= kParallelRadians * length) out.push_back({length, 0.5 * (a.x + b.x)});
  }
}

/// Coordinates across of the edges as long as the longest.
std::vector<double> across_longest(const std::vector<ParallelEdge>& edges) {
  constexpr double kTie = 1 - kSameLength_share;
  double longest = 0;
  for (const ParallelEdge& edge : edges) longest = std::max(longest, edge.length);
  std::vector<double> out;
  for (const ParallelEdge& edge : edges)
    if (edge.length > 0 && edge.length >= longest * kTie) out.push_back(edge.across);
  std::sort(out.begin(), out.end());
  return out;
}

/// Whether two coordinates across lie on the same grid of strips.
bool same_grid(double a, double b, double width_m) {
  return std::abs(std::remainder(a - b, width_m)) <= kSamePlace_m;
}

}  // namespace

std::vector<StripGrid> strip_grids(const Subfield& subfield, double width_m) {
  const TrackFrame frame(subfield.direction);
  const Ring outer = frame.to_track(subfield.shape.outer);
  std::vector<ParallelEdge> edges;
  append_parallel_edges(outer, edges);
  for (const Ring& hole : subfield.shape.holes) append_parallel_edges(frame.to_track(hole), edges);
  std::vector<double> origins = across_longest(edges);
  if (origins.empty()) origins = {bounds(outer).min_x, bounds(outer).max_x};

  std::vector<StripGrid> grids;
  for (const double origin : origins)
    if (std::none_of(grids.begin(), grids.end(),
                     [&](const StripGrid& grid) { return same_grid(grid.origin_m, origin, width_m); }))
      grids.push_back({frame, origin, width_m});
  return grids;
}

}  // namespace tramline
