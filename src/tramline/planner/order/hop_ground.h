#pragma once
// The ground that hops between track pieces lead over.

#include <vector>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/model/field.h"

namespace tramline::order {

/// How a machine gets from one place to another.
struct Hop {
  double length_m = 0;  ///< the straight line
  double way_round_m =
      0;                ///< the same with what lies in obstacles or outside the field led along their edges
  bool barred = false;  ///< the straight line leads through an obstacle or far outside the field
};

/// The boundary of a field and its obstacles, ready to be met by straight lines. Passable obstacles may be
/// driven over. Read by any number of threads.
class HopGround {
 public:
  /// Hops are far outside the field where the way along its edge is longer by more than `far_m`.
  HopGround(const Field& field, double far_m);

  /// Where the straight line enters an obstacle or leaves the field, the way round leads along the edge, by
  /// the shorter way. A place outside the field reaches its edge where that is nearest. O(edges within the
  /// box of the line), and of the rings left or entered O(edges) where a place lies beyond the edge.
  Hop hop(Point from, Point to) const;

 private:
  struct EdgeRing {
    Ring ring;
    std::vector<double> along_m;  ///< from the first corner to each corner, and all the way round
    Box box;
    bool field = false;  ///< the outer ring of the field; otherwise an obstacle
  };
  struct Meeting {
    std::size_t ring = 0;
    double share = 0;    ///< of the straight line
    double along_m = 0;  ///< of the ring
  };

  void add(const Ring& ring, bool field);
  std::vector<Meeting> meetings(Point from, Point to) const;
  bool inside(std::size_t ring, Point p) const;
  double nearest_along_m(const EdgeRing& ring, Point p) const;
  void lead_round(std::size_t ring, const std::vector<Meeting>& met, Point from, Point to, Hop& hop) const;

  std::vector<EdgeRing> rings_;
  std::vector<std::pair<std::size_t, std::size_t>> edges_;  ///< ring and corner an edge begins at
  BoxGrid grid_;
  double far_m_;
};

}  // namespace tramline::order
