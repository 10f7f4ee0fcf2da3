#pragma once
// Positions on the lines of tracks, and walks along them.

#include <tuple>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// A position on the line of a track.
struct TrackPosition {
  Point at;
  Point heading;       ///< heading of the line there, in the direction of its reference
  double along_m = 0;  ///< on a straight line: distance along it; else distance along the reference, of the
                       ///< position across from it or, in a corner, of the beginning of the corner
  double round_m = 0;  ///< distance along the arc of the corner
  bool in_corner = false;
};

/// Whether `a` comes before `b` along the line. Corners begin where the side before them ends.
inline bool before(const TrackPosition& a, const TrackPosition& b) {
  return std::tie(a.along_m, a.round_m) < std::tie(b.along_m, b.round_m);
}

/// The outcome of a walk along a line.
enum class WalkEnd { kReached, kPassed, kLineEnded };
struct Walk {
  Path path;
  WalkEnd end = WalkEnd::kLineEnded;
};

}  // namespace tramline::check
