#pragma once
// Intervals in any order, as a set.

#include "tramline/geometry/interval.h"

namespace tramline {

/// The positions of all the intervals, which may overlap and be in any order. O(n log n).
Intervals joined(Intervals all);

}  // namespace tramline
