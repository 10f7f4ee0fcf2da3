#pragma once
// Where along a strip its boundary lies, window by window.

#include <span>
#include <vector>

#include "tramline/cost/bound/strip_parts.h"

namespace tramline {

/// A stretch of a strip that holds parts of the boundary; none lies between it and the next window.
struct BoundaryWindow {
  double lowest = 0;  ///< coordinates along
  double highest = 0;
  std::span<const BoundaryPart> parts;
  /// One passage from side to side is all there is, and it turns back neither across nor along.
  bool passes = false;
  bool begins = false;                     ///< the region lies beyond the passage
  double across_m = 0;                     ///< how far the parts go across, all summed
  double least_slope = 0, most_slope = 0;  ///< of the parts against the line across, not negative
  bool inside_after = false;               ///< the strip's middle line is inside beyond the window
};

/// The windows of one strip from low to high; parts nearer along than `apart_m` share one. Sorts the parts.
/// The parts reach from −margin_m to width_m + margin_m across. O(p log p).
void gather_windows(std::span<BoundaryPart> parts, double width_m, double margin_m, double apart_m,
                    std::vector<BoundaryWindow>& out);

/// What a passage costs where each bit of land across is worked or left, whichever costs less:
/// min over the end y of λo·(worked in vain) + λu·(left), between 0 and width_m across.
/// Precondition: window.passes. O(p).
double passage_cost(const BoundaryWindow& window, double width_m, double over_price, double under_price);

}  // namespace tramline
