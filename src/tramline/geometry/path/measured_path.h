#pragma once
// A path with points looked up by their position along it.

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

struct PathPoint {
  Point at;
  Point heading;  ///< unit vector in driving direction
};

/// A path with the positions at which its segments begin.
class MeasuredPath {
 public:
  /// Precondition: no segment has length 0.
  explicit MeasuredPath(Path path);
  double length() const { return starts_.back(); }
  const Path& path() const { return path_; }
  /// The point at `along_m` from the beginning; the nearer end for positions beyond the path. O(log n).
  PathPoint at(double along_m) const;

 private:
  Path path_;
  std::vector<double> starts_;  ///< positions of the segments' starts, and the end of the last
};

}  // namespace tramline
