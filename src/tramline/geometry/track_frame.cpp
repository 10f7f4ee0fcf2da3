#include "tramline/geometry/track_frame.h"

namespace tramline {

Ring TrackFrame::to_track(const Ring& ring) const {
  Ring out;
  out.reserve(ring.size());
  for (const Point p : ring) out.push_back(to_track(p));
  return out;
}

Region TrackFrame::to_track(const Region& region) const {
  Region out;
  out.reserve(region.size());
  for (const Polygon& polygon : region) {
    Polygon turned{to_track(polygon.outer), {}};
    for (const Ring& hole : polygon.holes) turned.holes.push_back(to_track(hole));
    out.push_back(std::move(turned));
  }
  return out;
}

}  // namespace tramline
