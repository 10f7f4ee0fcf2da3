#pragma once
// The plane turned so that tracks run "up": across (c, to the right of the direction) and along (s).

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A rotation about the origin that takes the direction's unit vector to (0, 1). In the turned
/// plane x is the coordinate across the tracks and y the coordinate along them.
class TrackFrame {
 public:
  /// The field's own frame, not turned.
  TrackFrame() : TrackFrame(Direction::clockwise_from_north(Angle::radians(0))) {}
  explicit TrackFrame(Direction direction) : direction_(direction), up_(direction.unit()) {}
  Direction direction() const { return direction_; }
  Point to_track(Point p) const { return {p.x * up_.y - p.y * up_.x, p.x * up_.x + p.y * up_.y}; }
  Point to_field(Point p) const { return {p.x * up_.y + p.y * up_.x, p.y * up_.y - p.x * up_.x}; }
  Ring to_track(const Ring& ring) const;
  Region to_track(const Region& region) const;
  Region to_field(const Region& region) const;

 private:
  Direction direction_;
  Point up_;
};

}  // namespace tramline
