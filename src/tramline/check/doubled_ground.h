#pragma once
// Where more than one swath works.

#include <vector>

#include "tramline/check/worked_parts.h"
#include "tramline/geometry/region.h"

namespace tramline::check {

/// What any two of the polygons have in common, pair by pair, but for what is thinner than kThinnestShown_m:
/// where three lie over one another these parts do, too. Every polygon has to be valid.
/// O(n·log n + k) for k pairs whose boxes meet.
Region doubled_ground(const Region& swaths);

/// The same of the parts of swaths, without a look at those that have nothing in common for certain
/// (may_meet()): arcs side by side are many, and overlays of their chords take long.
Region doubled_ground(const std::vector<WorkedPart>& parts, double width_m);

}  // namespace tramline::check
