#pragma once
// The frame detours are built in: x along the track, y to the side of passing, the track at y = 0.

#include "tramline/geometry/path.h"
#include "tramline/model/detour.h"

namespace tramline {

/// For a track at x = centre of a grid's plane, driven up; left is towards smaller x. Passing on the
/// right mirrors the plane.
struct DetourFrame {
  double centre = 0;
  Passing side = Passing::kLeft;

  double sense() const { return side == Passing::kLeft ? 1 : -1; }
  Point to_detour(Point p) const { return {p.y, sense() * (centre - p.x)}; }
  Point to_strip(Point p) const { return {centre - sense() * p.y, p.x}; }
  Ring to_detour(const Ring& ring) const {
    Ring out;
    out.reserve(ring.size());
    for (const Point p : ring) out.push_back(to_detour(p));
    return out;
  }
  Path to_strip(const Path& path) const {
    Path out;
    out.reserve(path.size());
    for (const PathSegment& segment : path)
      out.push_back({to_strip(segment.from), to_strip(segment.to), sense() * segment.curvature});
    return out;
  }
};

}  // namespace tramline
