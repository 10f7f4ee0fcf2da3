#pragma once
// The transverse distribution of a machine, as measured.

#include <vector>

namespace tramline {

/// A relative rate at an offset across the machine. Between two points the rate changes linearly; beyond the
/// outermost points it is 0. Two points at one offset are a jump.
struct PatternPoint {
  double offset_m = 0;  ///< from the machine's middle, positive to the left
  double rate = 0;      ///< relative: only ratios count
};

/// The points from right to left or from left to right.
using SprayPattern = std::vector<PatternPoint>;

}  // namespace tramline
