#pragma once
// A detour compared with the line that it replaces: on which side of the detour obstacles lie.

#include <algorithm>
#include <limits>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// The distances from the replaced line of something on either side of the detour, m; infinite where nothing
/// lies on that side.
struct Sides {
  double left_m = std::numeric_limits<double>::infinity();
  double right_m = std::numeric_limits<double>::infinity();

  double nearest_m() const { return std::min(left_m, right_m); }
};

/// A detour and the line that it replaces. Left and right are those of the detour's heading.
class DetourCourse {
 public:
  /// `line`: the line that would have been driven from the beginning of the detour to its end. It turns by no
  /// more than half a circle in one segment, and has no kinks.
  DetourCourse(Path line, const Path& detour);

  /// The distances of the parts of a polygon that lie straight across from the line; both 0 where the line
  /// begins within the polygon. O(v·k·m) for v vertices, k segments of the line and m chords of the detour.
  Sides sides_of(const Polygon& land) const;
  /// The distance of a polygon from the line, including beyond its ends, m; 0 where they meet or the line
  /// lies within.
  double distance_to_line(const Polygon& land) const;
  /// Whether more of the area between line and detour lies to the left of the line than to its right.
  bool goes_left() const;
  /// The box round everything within `reach_m` of the line, field frame.
  Box line_box(double reach_m) const { return reach_of(line_, 2 * reach_m); }

 private:
  void look_at(const PathSegment& edge, Sides& out) const;
  bool is_right_of_detour(const PathSegment& segment, Point p) const;

  Path line_;
  Ring between_;  ///< the area between: along the detour, and back along the line
};

}  // namespace tramline::check
