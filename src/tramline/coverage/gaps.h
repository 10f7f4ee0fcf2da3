#pragma once
// Missed ground as a list.

#include <vector>

#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Smaller pieces of missed ground are no gaps, m².
inline constexpr double kLeastGap_m2 = 0.01;
/// How well the widest place of a gap is known, m.
inline constexpr double kGapWidth_m = 0.01;

/// The polygons of the missed region of at least kLeastGap_m2, the largest first, equal ones from west to
/// east.
std::vector<Gap> gaps_of(const Region& missed);

}  // namespace tramline::coverage
