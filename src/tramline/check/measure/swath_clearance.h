#pragma once
// A path with the flat-ended swath along it, and the distance of land from the swath.

#include <limits>
#include <optional>
#include <vector>

#include "tramline/check/measure/piece_frame.h"
#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// The closest approach of something to a swath.
struct Approach {
  /// Distance from the swath, m. Negative where it lies within: half the width less this is its distance from
  /// the path.
  double gap_m = std::numeric_limits<double>::infinity();
  Point at;  ///< a point on it near by, field frame
};

/// A path as part of a piece. Distances are taken in the piece's frame, exactly, along the arcs
/// themselves: nothing is too small or too thin to be found.
class SwathClearance {
 public:
  /// `path` in the field's frame; it begins and ends along the piece's line.
  SwathClearance(const PieceFrame& frame, const Path& path, double half_width_m);

  /// Smallest box, field frame, round all that is nearer to the swath than `reach_m`.
  Box field_box(double reach_m) const;
  /// The closest approach of a polygon, up to `reach_m` (which may be negative: within the swath only). Land
  /// touched by less than a millimetre behind the flat ends does not count. O(v·k) for v vertices within
  /// reach and k segments.
  Approach to_land(const Polygon& land, double reach_m) const;
  /// The same for a ring as a line.
  Approach to_ring(const Ring& ring, double reach_m) const;

  /// A point, field frame, where the path is more than a millimetre outside the ring; nullopt where there is
  /// none. O(v) where the ring is not near, else O(v·k) for k chords of the path.
  std::optional<Point> point_outside(const Ring& outer) const;
  /// The same, considering only points beside which the piece's line is inside: a track may end outside by
  /// its end rule.
  std::optional<Point> point_pushed_outside(const Ring& outer) const;

 private:
  struct Edge {
    Point a;
    Point b;
  };
  /// Cuts the edge to the length of the path: land beyond its start or end belongs to other parts of the
  /// piece.
  bool cut_to_length(Edge& edge) const;
  void approach(const Edge& edge, double reach_m, Approach& best) const;
  std::vector<Edge> near_edges(const Ring& ring, double reach_m) const;
  enum class Judged { kEverywhere, kWhereLineIsInside };
  std::optional<Point> point_outside(const Ring& outer, Judged judged) const;
  std::optional<Point> point_outside(const std::vector<Edge>& near, const Ring& outer, Judged judged,
                                     Point from, Point to) const;
  Point some_point() const;

  PieceFrame frame_;
  Path path_;  ///< in the piece's frame
  std::vector<Box> boxes_;
  Box box_;
  double half_m_;
  double from_m_;  ///< along the piece; infinite for a path that turns back
  double to_m_;
};

}  // namespace tramline::check
