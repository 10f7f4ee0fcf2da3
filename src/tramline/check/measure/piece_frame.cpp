#include "tramline/check/measure/piece_frame.h"

#include <cmath>

namespace tramline::check {
namespace {

/// The part of a ring where inside(p) >= 0, `inside` being linear. Where the ring falls apart, the
/// parts stay joined along the side, which adds no area.
template <class Side>
Ring clipped_by(const Ring& ring, Side inside) {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double da = inside(a), db = inside(b);
    if (da >= 0) out.push_back(a);
    if ((da >= 0) != (db >= 0)) out.push_back(a + (da / (da - db)) * (b - a));
  }
  return out;
}

Ring clipped_ring(const Ring& ring, const PieceFrame& frame, const Box& r) {
  Ring local;
  local.reserve(ring.size());
  for (const Point p : ring) local.push_back(frame.to_local(p));
  local = clipped_by(local, [&](Point p) { return p.x - r.min_x; });
  local = clipped_by(local, [&](Point p) { return r.max_x - p.x; });
  local = clipped_by(local, [&](Point p) { return p.y - r.min_y; });
  return clipped_by(local, [&](Point p) { return r.max_y - p.y; });
}

Point middle(const Ring& ring) {
  Point sum;
  for (const Point p : ring) sum = sum + p;
  return (1.0 / static_cast<double>(ring.size())) * sum;
}

}  // namespace

Box PieceFrame::field_box(const Box& local) const {
  Box out;
  for (const double x : {local.min_x, local.max_x})
    for (const double y : {local.min_y, local.max_y}) out.extend(to_field({x, y}));
  return out;
}

PieceFrame frame_of_detour(const TrackPiece& piece, const Path& detour) {
  return piece.curve.empty() ? PieceFrame(piece) : PieceFrame(detour.front().from, detour.back().to);
}

Clipped clipped(const Polygon& polygon, const PieceFrame& frame, const Box& rectangle) {
  Clipped out;
  const Ring outer = clipped_ring(polygon.outer, frame, rectangle);
  if (outer.size() < 3) return out;
  out.area_m2 = std::abs(signed_area(outer));
  out.at = frame.to_field(middle(outer));
  for (const Ring& hole : polygon.holes)
    out.area_m2 -= std::abs(signed_area(clipped_ring(hole, frame, rectangle)));
  return out;
}

}  // namespace tramline::check
