#pragma once
// The boundary of a polygon, indexed for the rays of one sweep direction.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tramline/decomposition/events.h"
#include "tramline/geometry/index/span_index.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

/// The first thing that a ray hits.
struct Hit {
  double reach = std::numeric_limits<double>::infinity();  ///< m; infinite: nothing is hit
  std::size_t ring = 0;                                    ///< 0: outer, then the holes
  std::size_t index = 0;                                   ///< the vertex, or the first one of the edge
  bool vertex = false;

  friend bool operator==(const Hit& a, const Hit& b) = default;
};

/// The polygon in the turned plane, where cuts are vertical, with its edges indexed across and along. O(n) to
/// build; queries are linear in the edges above, below or beside the point.
class TurnedBoundary {
 public:
  TurnedBoundary(const Polygon& polygon, const TrackFrame& frame);

  /// The nearest vertex or edge above (sense +1) or below (−1) of `start`, in the turned plane. Vertices
  /// within kSameLine of the ray are on it; of several equally near the first counts. Nothing is nearer than
  /// kSameLine.
  Hit nearest(Point start, int sense) const;

  /// The corners of all rings at a vertex; both in the field's plane.
  std::vector<SplitEvent> corners_at(Point vertex) const;

  /// Whether p lies inside, even-odd over all rings, in the turned plane.
  bool inside(Point p) const;

 private:
  struct Edge {
    Point from, to;  ///< turned
    std::uint32_t ring, index;
  };
  static std::vector<Edge> edges_of(const std::vector<const Ring*>& rings, const TrackFrame& frame);
  static SpanIndex by_coordinate(const std::vector<Edge>& edges, double Point::*coordinate);

  TrackFrame frame_;
  std::vector<const Ring*> rings_;  ///< in the field's plane
  std::vector<Edge> edges_;
  SpanIndex across_, along_;
};

}  // namespace tramline
