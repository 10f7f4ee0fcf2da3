#pragma once
// The part of a region in the cross-sections of a strip: the quantity that every end rule and the closed-form
// tally are built on.

#include <vector>

#include "tramline/geometry/interval.h"
#include "tramline/geometry/strip/strip_grid.h"

namespace tramline {

/// A stretch of a strip over which the length of the cross-section inside the region changes
/// linearly from width_from to width_to (m).
struct Slab {
  double from = 0;
  double to = 0;
  double width_from = 0;
  double width_to = 0;
  double width_at(double along) const {
    return width_from + (width_to - width_from) * (along - from) / (to - from);
  }
};

/// The part of a region in one strip. Positions are coordinates along the tracks.
struct StripProfile {
  std::vector<Slab> slabs;  ///< sorted, not overlapping; nothing of the region lies between them
  Intervals centre_line;    ///< where the strip's centre line is inside the region

  bool empty() const { return slabs.empty(); }
};

/// Profiles of strips range.first … range.last of the grid.
/// `turned` is the region in the grid's turned plane, rings oriented (outer counter-clockwise).
/// Exact up to rounding (about 1e-12 of the coordinates): every boundary edge is cut at the strip
/// lines and the cross-section is summed over the cut edges, m(y) = w·[right side inside] + Σ ±x_e(y).
/// O(n + K log K) for n edges and K incidences of edges and strips.
/// Strips that `wanted` leaves out get an empty profile.
std::vector<StripProfile> cross_sections(const Region& turned, const StripGrid& grid, StripRange range,
                                         const StripMask& wanted = {});

/// The stretches in which the cross-section is at least `width_m` (> 0) long.
Intervals where_at_least(const StripProfile& profile, double width_m);

/// Area of the region within the strip between two positions along, m².
double area_between(const StripProfile& profile, double from, double to);

}  // namespace tramline
