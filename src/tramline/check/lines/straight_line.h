#pragma once
// The line of a straight track: infinite, and measured exactly.

#include <optional>

#include "tramline/check/lines/track_position.h"

namespace tramline::check {

/// A line through a point in a heading. Positions are measured from the point.
class StraightLine {
 public:
  /// Precondition: the heading is a unit vector.
  StraightLine(Point through, Point heading);

  /// The position straight across from a point, however far off.
  TrackPosition foot_of(Point p) const;
  /// The position of a point on the line, to within kLengthTolerance_m; nullopt where the point is off the
  /// line.
  std::optional<TrackPosition> position_of(Point p) const;
  /// Walks forwards from one position to another; the walk ends as kLineEnded where the second lies behind.
  Walk walk(const TrackPosition& from, const TrackPosition& to) const;

 private:
  Point through_;
  Point heading_;
};

}  // namespace tramline::check
