#pragma once
// Missed ground as a list.

#include <cstddef>
#include <vector>

#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Smaller pieces of missed ground are no gaps, m².
inline constexpr double kLeastGap_m2 = 0.01;
/// Of so many gaps, the largest, the widest place is looked for, ...
inline constexpr std::size_t kMeasuredGaps = 100;
/// ... and known so well, m.
inline constexpr double kGapWidth_m = 0.01;

/// The polygons of the missed region of at least kLeastGap_m2, the largest first, equal ones from west to
/// east. Of those after kMeasuredGaps the width is NaN, and the centre some place well inside.
std::vector<Gap> gaps_of(const Region& missed);

}  // namespace tramline::coverage
