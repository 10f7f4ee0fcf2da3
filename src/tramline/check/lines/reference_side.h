#pragma once
// One side of a plan's reference line, with distances from the line and points beside it.

#include <cstddef>
#include <limits>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// The position on a line that is nearest to a point.
struct Foot {
  double along_m = 0;  ///< from the beginning of the line
  double off_m = std::numeric_limits<double>::infinity();
  bool on_right = false;  ///< whether the point lies to the right of the line
  bool square = false;  ///< whether the point lies straight across from the line, not beyond one of its ends
};

/// A line whose tracks lie to its right, with boxes of its segments for finding nearest positions.
/// Precondition: the line is sound (fault_of()).
class ReferenceSide {
 public:
  explicit ReferenceSide(Path line);

  double length_m() const { return starts_m_.back(); }
  /// Whether the line ends where it begins, in the same heading.
  bool round() const { return round_; }
  /// Whether one of its ends lies on the line. Only then may a parallel be closed.
  bool touches_itself() const { return touches_itself_; }

  /// The nearest position on the line; off_m is infinite where none is nearer than `within_m`.
  Foot foot_of(Point p, double within_m = std::numeric_limits<double>::infinity()) const;
  /// Whether the line keeps the distance from the point, up to rounding.
  bool keeps_off(Point p, double distance_m) const;

  Point heading_at(double along_m) const;
  /// The point `off_m` to the right of a position on the line.
  Point beside(double along_m, double off_m) const;
  /// Curvature of the line at a position, left positive, 1/m; at a joint that of the segment ahead.
  double curvature_at(double along_m) const;
  /// Appends to `out` the line between two positions, moved to the right segment by segment.
  void append_beside(double from_m, double to_m, double off_m, Path& out) const;

 private:
  std::size_t segment_at(double along_m) const;
  /// Calls `look(segment)` for the segments that may be nearer than the distance it returned last.
  template <class Look>
  void each_near(Point p, double within_m, Look look) const;

  Path line_;
  std::vector<double> starts_m_;  ///< where each segment begins, and the end of the last
  std::vector<Box> boxes_;        ///< of the segments
  std::vector<Box> groups_;       ///< boxes of groups of consecutive segments
  bool round_ = false;
  bool touches_itself_ = false;
};

}  // namespace tramline::check
