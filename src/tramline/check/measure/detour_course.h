#pragma once
// A detour beside the line that it left: which side of it things are on.

#include <algorithm>
#include <limits>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// How near to the line that was left something lies, on either side of the detour, m; infinite where nothing
/// does.
struct Sides {
  double left_m = std::numeric_limits<double>::infinity();
  double right_m = std::numeric_limits<double>::infinity();

  double nearest_m() const { return std::min(left_m, right_m); }
};

/// Left and right are those of the detour's heading.
class DetourCourse {
 public:
  /// `line`: what would have been driven from where the detour begins to where it ends. It turns by no more
  /// than half a circle in one segment, and has no kinks.
  DetourCourse(Path line, const Path& detour);

  /// Of the parts of a polygon that lie straight across from a place of the line; both 0 where the line
  /// begins within it. O(v·k·m) for v vertices, k segments of the line and m chords of the detour.
  Sides sides_of(const Polygon& land) const;
  /// How far a polygon is from the line, beyond its ends, too, m; 0 where they meet or it lies within.
  double distance_to_line(const Polygon& land) const;
  /// Is there more ground between line and detour on the left of the line than on its right?
  bool goes_left() const;
  /// Round all that is so near to the line, field frame.
  Box line_box(double reach_m) const { return reach_of(line_, 2 * reach_m); }

 private:
  void look_at(const PathSegment& edge, Sides& out) const;
  bool is_right_of_detour(const PathSegment& segment, Point p) const;

  Path line_;
  Ring between_;  ///< along the detour, and back along the line
};

}  // namespace tramline::check
