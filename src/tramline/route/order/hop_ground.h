#pragma once
// The field and obstacles that hops between track pieces lead over.

#include <vector>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/model/field.h"

namespace tramline::order {

/// The way of a machine from one point to another.
struct Hop {
  double length_m = 0;  ///< the straight line
  /// The same, but along the edges where the line is in an obstacle or outside the field.
  double way_round_m = 0;
  bool barred = false;  ///< the straight line leads through an obstacle or far outside the field
};

/// The boundary of a field and its obstacles, prepared for intersection with straight lines. Passable
/// obstacles may be driven over. Safe to read from any number of threads.
class HopGround {
 public:
  /// A hop counts as far outside the field where the way along the field's edge is longer by more than
  /// `far_m`.
  HopGround(const Field& field, double far_m);

  /// Where the straight line enters an obstacle or leaves the field, the way round follows the edge in the
  /// shorter direction. A point outside the field joins its edge at the nearest point. O(edges within the box
  /// of the line); where an end lies beyond the edge also O(edges) of the rings entered or left.
  Hop hop(Point from, Point to) const;

 private:
  struct EdgeRing {
    Ring ring;
    std::vector<double> along_m;  ///< from the first corner to each corner, and all the way round
    Box box;
    bool field = false;  ///< whether it is the outer ring of the field; otherwise an obstacle
  };
  struct EdgeCrossing {
    std::size_t ring = 0;
    double share = 0;    ///< position along the straight line, 0 to 1
    double along_m = 0;  ///< position along the ring
  };

  void add(const Ring& ring, bool field);
  std::vector<EdgeCrossing> edge_crossings(Point from, Point to) const;
  bool inside(std::size_t ring, Point p) const;
  double nearest_along_m(const EdgeRing& ring, Point p) const;
  void lead_round(std::size_t ring, const std::vector<EdgeCrossing>& crossed, Point from, Point to,
                  Hop& hop) const;

  std::vector<EdgeRing> rings_;
  std::vector<std::pair<std::size_t, std::size_t>> edges_;  ///< ring and corner an edge begins at
  BoxGrid grid_;
  double far_m_;
};

}  // namespace tramline::order
