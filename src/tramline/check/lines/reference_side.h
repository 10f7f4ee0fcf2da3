#pragma once
// One side of a plan's reference line: what is beside it, and how far from it.

#include <cstddef>
#include <limits>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// The place of a line that is nearest to a point.
struct Foot {
  double along_m = 0;  ///< from the beginning of the line
  double off_m = std::numeric_limits<double>::infinity();
  bool on_right = false;  ///< the point lies to the right of the line
  bool square = false;    ///< the point lies across the line there, and not beyond one of its ends
};

/// A line whose tracks lie to its right, with the nearest place looked up among boxes of its segments.
/// Precondition: the line is sound (fault_of()).
class ReferenceSide {
 public:
  explicit ReferenceSide(Path line);

  double length_m() const { return starts_m_.back(); }
  /// Does the line end where it begins, in the same heading?
  bool round() const { return round_; }
  /// Does one of its ends lie on the line? Only then may a parallel be closed.
  bool touches_itself() const { return touches_itself_; }

  /// off_m is infinite where no place is nearer than `within_m`.
  Foot foot_of(Point p, double within_m = std::numeric_limits<double>::infinity()) const;
  /// No place of the line is nearer to the point than the distance, but for rounding.
  bool keeps_off(Point p, double distance_m) const;

  Point heading_at(double along_m) const;
  /// The point `off_m` to the right of a place.
  Point beside(double along_m, double off_m) const;
  /// Curvature of the line there, left positive, 1/m; of two segments the one ahead.
  double curvature_at(double along_m) const;
  /// The line between two places moved to its right, segment by segment, onto the end of `out`.
  void append_beside(double from_m, double to_m, double off_m, Path& out) const;

 private:
  std::size_t segment_at(double along_m) const;
  /// Calls `look(segment)` where that may be nearer than what it returned last.
  template <class Look>
  void each_near(Point p, double within_m, Look look) const;

  Path line_;
  std::vector<double> starts_m_;  ///< of the segments, and the end
  std::vector<Box> boxes_;        ///< of the segments
  std::vector<Box> groups_;       ///< of so many segments in a row
  bool round_ = false;
  bool touches_itself_ = false;
};

}  // namespace tramline::check
