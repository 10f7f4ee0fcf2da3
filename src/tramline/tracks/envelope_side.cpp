#include "tramline/tracks/envelope_side.h"

#include <cassert>

#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

std::pair<Point, Point> envelope_side(Point a, Point b, const Region& body) {
  assert(!(a == b));
  assert(!body.empty());
  const TrackFrame frame(Direction::along(a, b));
  const Box envelope = bounds(frame.to_track(body));
  // Directions have no sense; the line has.
  const bool upwards = frame.to_track(b).y > frame.to_track(a).y;
  const double across_m = upwards ? envelope.min_x : envelope.max_x;
  const Point low = frame.to_field({across_m, envelope.min_y});
  const Point high = frame.to_field({across_m, envelope.max_y});
  return upwards ? std::pair(low, high) : std::pair(high, low);
}

}  // namespace tramline
