#pragma once
// The stretches of a strip that hold parts of the boundary, as windows.

#include <span>
#include <vector>

#include "tramline/cost/bound/strip_parts.h"

namespace tramline {

/// A stretch of a strip that holds parts of the boundary; there are none between it and the next window.
struct BoundaryWindow {
  double lowest = 0;  ///< coordinates along
  double highest = 0;
  std::span<const BoundaryPart> parts;
  /// Whether the window holds just one passage from side to side, which turns back neither across nor along.
  bool passes = false;
  bool begins = false;                     ///< the region lies beyond the passage
  double across_m = 0;                     ///< sum of the parts' extents across
  double least_slope = 0, most_slope = 0;  ///< of the parts against the line across, not negative
  bool inside_after = false;               ///< whether the strip's middle line is inside beyond the window
};

/// The windows of one strip from low to high; parts less than `apart_m` apart along the strip share one.
/// Sorts the parts. The parts reach from −margin_m to width_m + margin_m across. O(p log p).
void gather_windows(std::span<BoundaryPart> parts, double width_m, double margin_m, double apart_m,
                    std::vector<BoundaryWindow>& out);

/// Cost of a passage where each piece of land across is worked or left unworked, whichever costs less: min
/// over the end y of λo·(worked outside) + λu·(left unworked), between 0 and width_m across. Precondition:
/// window.passes. O(p).
double passage_cost(const BoundaryWindow& window, double width_m, double over_price, double under_price);

}  // namespace tramline
