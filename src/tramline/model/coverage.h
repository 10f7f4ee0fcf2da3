#pragma once
// What was worked of a field, as areas and regions.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "tramline/geometry/region.h"

namespace tramline {

/// How often ground was worked is counted up to here: 0, 1, 2, 3 and more.
inline constexpr int kMostCounted = 3;

/// Areas of what was worked so far, m². Without a field everything lies outside, and nothing is missed.
///
/// repeated: ground worked again that had been worked before and that no quad of the same run within the
/// last w of travel covers. sliver: ground worked at least twice, but never repeated so: the inside of
/// curves. repeated + sliver = worked at least twice, what S3 counts as repeated (S3.8).
struct CoverageAreas {
  double gross_m2 = 0;           ///< Σ areas of the quads
  double covered_m2 = 0;         ///< worked once or more
  double covered_inside_m2 = 0;  ///< of that, within the field
  double outside_m2 = 0;         ///< of that, outside it
  double repeated_m2 = 0;
  double sliver_m2 = 0;
  double missed_m2 = 0;  ///< field − covered
  /// Ground worked exactly 1, 2 times, 3 times or more; [0]: the missed ground. Exact in every engine that
  /// counts; NaN where it was not asked for.
  std::array<double, kMostCounted + 1> worked_times_m2{};

  double worked_twice_m2() const { return repeated_m2 + sliver_m2; }
};

/// What a place may be.
enum class Ground {
  kCovered,
  kRepeated,
  kSliver,
  kMissed,
  kOutside,  ///< covered outside the field
  kOnce,     ///< worked exactly once
  kTwice,    ///< exactly twice
  kOften,    ///< three times or more
};

}  // namespace tramline
