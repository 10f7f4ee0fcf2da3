#pragma once
// The plan that most people would expect, with all tracks along the longest side of the field.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The direction of the longest side of the field's outer ring. Corners that lie within half the working
/// width of a line through others are ignored, because surveyed sides are rarely one edge. Among equals the
/// first. O(n²) at worst.
Direction longest_side(const Field& field, double width_m);

/// The land undivided with tracks along the longest side, on the cheapest of some grids: flush with either
/// edge of the land, and at eight offsets across a track. Deterministic for any number of threads.
Candidate along_longest_side(const SearchTask& task, const SearchContext& context);

}  // namespace tramline
