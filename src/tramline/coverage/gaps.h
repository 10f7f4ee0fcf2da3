#pragma once
// The list of gaps: the parts of the missed land.

#include <cstddef>
#include <vector>

#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Smaller pieces of missed land do not count as gaps, m².
inline constexpr double kLeastGap_m2 = 0.01;
/// The number of gaps, the largest, whose width is measured, ...
inline constexpr std::size_t kMeasuredGaps = 100;
/// ... and the accuracy of the width, m.
inline constexpr double kGapWidth_m = 0.01;

/// The polygons of the missed region of at least kLeastGap_m2, the largest first, equal ones from west to
/// east. Beyond the first kMeasuredGaps the width is NaN, and the centre is some point well inside.
std::vector<Gap> gaps_of(const Region& missed);

}  // namespace tramline::coverage
