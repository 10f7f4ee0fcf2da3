#pragma once
// The edges of land, moved outwards by a tolerance.

#include "tramline/geometry/index/edge_index.h"

namespace tramline {

/// The region with every edge moved outwards by the distance: corners with mitres, at most kFarthestMitre
/// times as long. Vertices nearer to the one before than kTouchesEdge_m are left out. Meant for distances far
/// below the size of anything on the land: smaller holes than that turn inside out. Oriented.
Region slightly_grown(const Region& land, double by_m);

/// An index of edges that also tells which points they enclose. O(n) to build.
class LandEdges {
 public:
  explicit LandEdges(const Region& oriented) : index_(oriented) {}

  const std::vector<EdgeIndex::Edge>& edges() const { return index_.edges(); }
  const BoxGrid& grid() const { return index_.grid(); }
  /// Even-odd over the edges that a ray to the right meets; points on an edge may go either way. About
  /// O(√n).
  bool contains(Point p) const;
  /// Whether the edges enclose only one of two points, as contains() has them: far quicker where they are
  /// near one another. Even-odd over the edges between them; where one of these is in line with a point, or
  /// with the way from one to the other, contains() decides.
  bool lie_between(Point a, Point b) const;

 private:
  EdgeIndex index_;
};

}  // namespace tramline
