#include "tramline/geometry/polygon/outline_distance.h"

#include <algorithm>
#include <limits>

namespace tramline {

double distance_to_outline(Point p, const Ring& ring) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    least_m = std::min(least_m, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  return least_m;
}

double distance_to_outline(Point p, const Polygon& polygon) {
  double least_m = distance_to_outline(p, polygon.outer);
  for (const Ring& hole : polygon.holes) least_m = std::min(least_m, distance_to_outline(p, hole));
  return least_m;
}

}  // namespace tramline
