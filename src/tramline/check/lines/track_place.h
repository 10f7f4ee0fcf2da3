#pragma once
// Places on the lines of tracks, and ways along them.

#include <tuple>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// A place on the line of a track.
struct TrackPlace {
  Point at;
  Point heading;       ///< of the line there, in that of its reference
  double along_m = 0;  ///< of a straight line; else of the place of the reference across from it, in a corner
                       ///< of that where the corner begins
  double round_m = 0;  ///< how far round the corner, along its arc
  bool in_corner = false;
};

/// By their order along the line. Corners begin where the side before them ends.
inline bool before(const TrackPlace& a, const TrackPlace& b) {
  return std::tie(a.along_m, a.round_m) < std::tie(b.along_m, b.round_m);
}

/// How a walk along a line ended.
enum class WalkEnd { kReached, kPassed, kLineEnded };
struct Walk {
  Path path;
  WalkEnd end = WalkEnd::kLineEnded;
};

}  // namespace tramline::check
