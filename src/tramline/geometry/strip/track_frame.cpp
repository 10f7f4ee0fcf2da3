#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

template <class Motion>
Ring moved(const Ring& ring, Motion move) {
  Ring out;
  out.reserve(ring.size());
  for (const Point p : ring) out.push_back(move(p));
  return out;
}

template <class Motion>
Region moved(const Region& region, Motion move) {
  Region out;
  out.reserve(region.size());
  for (const Polygon& polygon : region) {
    Polygon part{moved(polygon.outer, move), {}};
    for (const Ring& hole : polygon.holes) part.holes.push_back(moved(hole, move));
    out.push_back(std::move(part));
  }
  return out;
}

}  // namespace

Ring TrackFrame::to_track(const Ring& ring) const {
  return moved(ring, [this](Point p) { return to_track(p); });
}

Region TrackFrame::to_track(const Region& region) const {
  return moved(region, [this](Point p) { return to_track(p); });
}

Region TrackFrame::to_field(const Region& region) const {
  return moved(region, [this](Point p) { return to_field(p); });
}

}  // namespace tramline
