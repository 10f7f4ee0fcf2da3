#pragma once
// The frame detours are made in: x along the track, y to the side of passing.

#include "tramline/geometry/path/path.h"
#include "tramline/model/detour.h"

namespace tramline {

/// x runs along the track's tangent at one of its points. Passing on the right mirrors the plane. Shapes are
/// moved to and from the plane of the track.
class DetourFrame {
 public:
  /// `along`: a unit vector in the track's direction.
  DetourFrame(Point origin, Point along, Passing side)
      : origin_(origin), along_(along), sense_(side == Passing::kLeft ? 1 : -1) {}
  /// For a track at x = `centre` that runs towards +y; x of the frame is y of the plane.
  DetourFrame(double centre, Passing side) : DetourFrame({centre, 0}, {0, 1}, side) {}

  Point to_detour(Point p) const {
    const Point off = p - origin_;
    return {dot(off, along_), sense_ * cross(along_, off)};
  }
  Point to_plane(Point p) const {
    const double left = sense_ * p.y;
    return {origin_.x + p.x * along_.x - left * along_.y, origin_.y + p.x * along_.y + left * along_.x};
  }
  Ring to_detour(const Ring& ring) const {
    Ring out;
    out.reserve(ring.size());
    for (const Point p : ring) out.push_back(to_detour(p));
    return out;
  }
  Path to_detour(const Path& path) const {
    return mirrored(moved(path, [this](Point p) { return to_detour(p); }));
  }
  Path to_plane(const Path& path) const {
    return mirrored(moved(path, [this](Point p) { return to_plane(p); }));
  }

 private:
  /// In the mirrored plane a left turn is a right one.
  Path mirrored(Path path) const {
    for (PathSegment& segment : path) segment.curvature *= sense_;
    return path;
  }

  Point origin_;
  Point along_;
  double sense_;
};

}  // namespace tramline
