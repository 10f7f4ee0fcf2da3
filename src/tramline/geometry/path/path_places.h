#pragma once
// Places along a path, by how far along it they are.

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

struct PathPlace {
  Point at;
  Point heading;  ///< unit vector in driving direction
};

/// A path ready to be asked for places on it.
class PathPlaces {
 public:
  /// Precondition: segments have a length.
  explicit PathPlaces(Path path);
  double length() const { return starts_.back(); }
  const Path& path() const { return path_; }
  /// `along_m` from the beginning; the nearer end where it lies beyond. O(log n).
  PathPlace at(double along_m) const;

 private:
  Path path_;
  std::vector<double> starts_;  ///< of the segments, and the end of the last
};

}  // namespace tramline
