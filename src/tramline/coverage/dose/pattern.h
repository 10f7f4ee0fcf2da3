#pragma once
// The transverse pattern a machine lays with, scaled to its working width.

#include <string>
#include <vector>

#include "tramline/model/spray_pattern.h"

namespace tramline::coverage {

/// Relative rate over a stretch across the machine, changing evenly. Offsets in metres, positive to the left.
struct PatternStretch {
  double right_m = 0;
  double left_m = 0;
  double at_right = 1;
  double at_left = 1;
};

/// The stretches of a pattern from right to left; 0 beyond them. Their integral is the working width, so that
/// the rate of a machine is the mean over its width, whatever the pattern.
class TransversePattern {
 public:
  /// The same everywhere.
  TransversePattern();
  /// Throws kBadInput, with `place` in front, for fewer than two points, numbers that are not finite,
  /// negative rates, offsets that go back and forth, more than two points at one offset, and rates that are
  /// all 0, or so small that they come to nothing.
  TransversePattern(SprayPattern points, double width_m, const std::string& place);

  bool even() const { return stretches_.empty(); }
  double right_m() const;  ///< where it ends; meaningless for an even one
  double left_m() const;
  /// Those of the range, cut to it. Precondition: right_m < left_m.
  std::vector<PatternStretch> within(double right_m, double left_m) const;

 private:
  std::vector<PatternStretch> stretches_;
};

}  // namespace tramline::coverage
