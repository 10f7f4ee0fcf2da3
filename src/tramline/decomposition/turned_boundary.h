#pragma once
// The boundary of a polygon as the rays of one sweep direction meet it.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tramline/decomposition/events.h"
#include "tramline/geometry/index/span_index.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

/// What a ray meets first.
struct Hit {
  double reach = std::numeric_limits<double>::infinity();  ///< infinite: nothing
  std::size_t ring = 0;                                    ///< 0: outer, then the holes
  std::size_t index = 0;                                   ///< the vertex, or the first one of the edge
  bool vertex = false;

  friend bool operator==(const Hit& a, const Hit& b) = default;
};

/// The polygon in the turned plane, where cuts are vertical; its edges by where they lie across and along.
/// Made in O(n); the questions take as long as there are edges above, below or beside the point.
class TurnedBoundary {
 public:
  TurnedBoundary(const Polygon& polygon, const TrackFrame& frame);

  /// The nearest vertex or edge above (sense +1) or below (−1) of `start`, in the turned plane. Vertices
  /// within kSameLine of the ray are on it; of several as near the first. Nothing is nearer than kSameLine.
  Hit nearest(Point start, int sense) const;

  /// The corners of all rings at a vertex. Both in the field's plane.
  std::vector<SplitEvent> corners_at(Point vertex) const;

  /// Even-odd over all rings, in the turned plane.
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
