#pragma once
// The frame of a piece, and areas of land within rectangles aligned with it.

#include <cassert>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/track.h"

namespace tramline::check {

/// Origin at the piece's start, x across (to the right), y along. Coordinates near the piece are
/// small, so that areas of a square millimetre stand out from rounding.
class PieceFrame {
 public:
  /// Precondition: start != end.
  PieceFrame(Point start, Point end)
      : origin_(start), up_((1 / distance(start, end)) * (end - start)), length_(distance(start, end)) {
    assert(start != end);
  }
  explicit PieceFrame(const TrackPiece& piece) : PieceFrame(piece.start, piece.end) {}

  double length() const { return length_; }
  Point to_local(Point p) const {
    const Point d = p - origin_;
    return {d.x * up_.y - d.y * up_.x, dot(d, up_)};
  }
  Point to_field(Point p) const {
    return {origin_.x + p.x * up_.y + p.y * up_.x, origin_.y + p.y * up_.y - p.x * up_.x};
  }
  /// Smallest axis-parallel box, in the field's frame, round a rectangle of this frame.
  Box field_box(const Box& local) const;

 private:
  Point origin_;
  Point up_;
  double length_;
};

/// The frame for checking a detour: that of its straight piece, or one along its own chord where the piece is
/// curved.
PieceFrame frame_of_detour(const TrackPiece& piece, const Path& detour);

/// The part of some land within a rectangle.
struct Clipped {
  double area_m2 = 0;
  Point at;  ///< a point on it, field frame; undefined where there is none
};

/// The part of a polygon within a rectangle of the piece's frame. Clips ring by ring against the four
/// sides: no overlay, no grid, so tiny areas are right. O(v).
Clipped clipped(const Polygon& polygon, const PieceFrame& frame, const Box& rectangle);

}  // namespace tramline::check
