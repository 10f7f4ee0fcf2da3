#pragma once
// How much lands where across a machine, as somebody measured it.

#include <vector>

namespace tramline {

/// A relative rate at a place across the machine; between two places it changes evenly, beyond the outermost
/// nothing lands. Two at one offset are a jump.
struct PatternPoint {
  double offset_m = 0;  ///< from the machine's middle, positive to the left
  double rate = 0;      ///< relative: only ratios count
};

/// From right to left or from left to right.
using SprayPattern = std::vector<PatternPoint>;

}  // namespace tramline
