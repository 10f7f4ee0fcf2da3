#pragma once
// The plan that most people would expect: all tracks along the longest side of the field.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The longest edge of the field's outer ring, once corners that lie within half the working width of a line
/// through others are left out: surveyed sides are rarely one edge. Among equals the first. O(n²) at worst.
Direction longest_side(const Field& field, double width_m);

/// The ground undivided with tracks along the longest side, on the cheapest of some grids: flush with either
/// edge of the ground, and in eight places across a track. Deterministic for any number of threads.
Candidate along_longest_side(const SearchTask& task, const SearchContext& context);

}  // namespace tramline
