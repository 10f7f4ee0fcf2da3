#include "server/map/few_corners.h"

#include <algorithm>

#include "tramline/geometry/path/simplified_line.h"

namespace tramline::server {
namespace {

constexpr std::size_t kTriangle = 3;

Ring thinned_ring(const Ring& ring, double detail_m) {
  if (detail_m <= 0 || ring.size() <= kTriangle) return ring;
  Ring closed = ring;
  closed.push_back(closed.front());
  Ring out = thinned_line(closed, detail_m);
  out.pop_back();
  return out.size() < kTriangle ? ring : out;
}

}  // namespace

Ring few_corners(const Ring& ring, double share) {
  if (ring.size() <= kTriangle) return ring;
  const Box box = bounds(ring);
  return thinned_ring(ring, share * std::max(box.width(), box.height()));
}

std::vector<Point> thinned_line(const std::vector<Point>& line, double detail_m) {
  if (detail_m <= 0 || line.size() <= 2) return line;
  std::vector<Point> out;
  for (const std::size_t i : simplified_line(line, detail_m)) out.push_back(line[i]);
  return out;
}

Polygon thinned_polygon(const Polygon& polygon, double detail_m) {
  Polygon out{thinned_ring(polygon.outer, detail_m), {}};
  for (const Ring& hole : polygon.holes) out.holes.push_back(thinned_ring(hole, detail_m));
  return out;
}

}  // namespace tramline::server
