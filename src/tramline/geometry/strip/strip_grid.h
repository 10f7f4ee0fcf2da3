#pragma once
// The grid of parallel strips that tracks of one direction lie on.

#include <cmath>
#include <vector>

#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

/// Strip k covers the coordinates across [line(k), line(k + 1)] of the turned plane.
struct StripGrid {
  TrackFrame frame;
  double origin_m = 0;  ///< coordinate across of line 0
  double width_m = 1;   ///< > 0

  double line(int k) const { return origin_m + k * width_m; }
  double centre(int k) const { return origin_m + (k + 0.5) * width_m; }
  /// The strip k with line(k) <= across < line(k + 1), exactly by the values of line().
  int strip_at(double across) const {
    int k = static_cast<int>(std::floor((across - origin_m) / width_m));
    while (across < line(k)) --k;
    while (across >= line(k + 1)) ++k;
    return k;
  }
};

/// Strips first … last, both included; empty where last < first.
struct StripRange {
  int first = 0;
  int last = -1;
  int size() const { return last < first ? 0 : last - first + 1; }
};

/// A selection of the strips of a range, by k − first; empty: all of them.
using StripMask = std::vector<bool>;

/// The strips whose interior meets the box of turned coordinates by more than `slack_m`.
StripRange strips_over(const StripGrid& grid, const Box& turned, double slack_m);

}  // namespace tramline
