#include "tramline/admission/disputed_land.h"

#include <cassert>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline {

int winding_number(const Ring& ring, Point p) {
  int winding = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j], b = ring[i];
    const bool up = a.y <= p.y && b.y > p.y, down = a.y > p.y && b.y <= p.y;
    const double side = cross(b - a, p - a);
    if (up && side > 0) ++winding;
    if (down && side < 0) --winding;
  }
  return winding;
}

Region disputed_land(const Ring& ring) {
  assert(ring.size() >= 3);
  const Box frame = bounds(ring).grown(1);
  const Polygon sheet{{{frame.min_x, frame.min_y},
                       {frame.max_x, frame.min_y},
                       {frame.max_x, frame.max_y},
                       {frame.min_x, frame.max_y}},
                      {}};
  Ring closed = ring;
  closed.push_back(ring.front());
  Region out;
  for (Polygon& face : split_by_lines(sheet, {closed})) {
    const int winding = winding_number(ring, interior_point(face));
    if (winding != 0 && winding % 2 == 0) out.push_back(std::move(face));
  }
  return out;
}

}  // namespace tramline
