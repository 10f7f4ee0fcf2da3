#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

struct ParallelEdge {
  double length = 0;
  double across = 0;
};

void keep_longest_parallel_edge(const Ring& turned, ParallelEdge& longest) {
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Point a = turned[i], b = turned[(i + 1) % turned.size()];
    const double length = distance(a, b);
    if (length <= longest.length || std::abs(b.x - a.x) > kParallelRadians * length) continue;
    longest = {length, 0.5 * (a.x + b.x)};
  }
}

}  // namespace

StripGrid strip_grid(const Subfield& subfield, double width_m) {
  const TrackFrame frame(subfield.direction);
  const Ring outer = frame.to_track(subfield.shape.outer);
  ParallelEdge edge;
  keep_longest_parallel_edge(outer, edge);
  for (const Ring& hole : subfield.shape.holes) keep_longest_parallel_edge(frame.to_track(hole), edge);
  return {frame, edge.length > 0 ? edge.across : bounds(outer).min_x, width_m};
}

}  // namespace tramline
