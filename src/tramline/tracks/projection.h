#pragma once
// The projection of points onto a polyline (⊥ of Zhou §2.2).

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// A polyline onto which points are projected.
class Projection {
 public:
  /// Precondition: straight segments with lengths.
  explicit Projection(const Path& path);

  /// Positions along the path, m, of all its points that are nearest to `p`, ascending and at least one:
  /// several where p is equidistant from parts of the path, up to kEquidistant_m. A point beside the end of a
  /// segment is a foot only if the path comes no nearer on either side of it. O(n).
  std::vector<double> feet(Point p) const;

 private:
  struct Side {
    Point from;
    Point along;
    double length_m;
    double at_m;
  };
  std::vector<Side> sides_;
};

}  // namespace tramline
