#pragma once
// The line of a straight track: endless, and measured exactly.

#include <optional>

#include "tramline/check/lines/track_place.h"

namespace tramline::check {

/// Through a point, in a heading. Places are counted from the point.
class StraightLine {
 public:
  /// Precondition: the heading is a unit vector.
  StraightLine(Point through, Point heading);

  /// The place across from a point, however far off.
  TrackPlace foot_of(Point p) const;
  /// Where a point lies on the line, or so near to it as kLengthTolerance_m; nullopt where it is off it.
  std::optional<TrackPlace> place_of(Point p) const;
  /// Forwards from one place to another; the line ends where the second lies behind.
  Walk walk(const TrackPlace& from, const TrackPlace& to) const;

 private:
  Point through_;
  Point heading_;
};

}  // namespace tramline::check
