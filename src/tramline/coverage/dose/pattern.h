#pragma once
// The transverse pattern of a machine, scaled to its working width.

#include <string>
#include <vector>

#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// Relative rate over a stretch across the machine, changing linearly. Offsets in metres, positive to the
/// left.
struct PatternStretch {
  double right_m = 0;
  double left_m = 0;
  double at_right = 1;
  double at_left = 1;
};

/// A pattern as stretches from right to left; the rate is 0 beyond them. Their integral is the working width,
/// so that the rate of a machine is the mean over its width, whatever the pattern.
class TransversePattern {
 public:
  /// The same rate over the whole width.
  TransversePattern();
  /// Throws kBadInput, with `place` at the beginning of the message, for fewer than two points, numbers that
  /// are not finite, negative rates, offsets that go back and forth, more than two points at one offset, and
  /// rates that are all 0, or so small that they come to nothing.
  TransversePattern(SprayPattern points, double width_m, const std::string& place);

  bool even() const { return stretches_.empty(); }
  double right_m() const;  ///< right end; meaningless for an even pattern
  double left_m() const;
  /// The stretches within the range, cut to it. Precondition: right_m < left_m.
  std::vector<PatternStretch> within(double right_m, double left_m) const;

 private:
  std::vector<PatternStretch> stretches_;
};

}  // namespace tramline::coverage
