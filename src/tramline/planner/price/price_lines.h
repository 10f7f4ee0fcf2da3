#pragma once
// The figures of lines that somebody else drew or planned (Versleijen §3.3: reference plans of others).

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/model/report.h"
#include "tramline/planner/price/given_lines.h"

namespace tramline {

struct PricedLines {
  Plan plan;                     ///< with PlanOrigin::kLines
  std::vector<Skipped> skipped;  ///< lines that are too short to be one
};

/// The plan that given lines are. Each is a piece of a track, worked over its whole length; passes are
/// headland passes. Figures are those of any plan: overlap = Σ w·L − area(∪ swaths ∩ land), uncovered =
/// area(land) − area(∪ swaths ∩ land), with the field less its obstacles for land; so Σ w·L = land −
/// uncovered
/// + overlap whatever the lines do: cross, double one another, leave the field or fold. Swaths of lines with
/// kinks are those of kinked_cells(); arcs tighter than half the width are worked along chords within a
/// centimetre. What of the land the passes work is the plan's headland, the rest its body.
///
/// Turns are pieces − 1 − crossings. A piece is one after a crossing where it goes on ahead of the piece
/// before it, no more than half a width beside it, behind a passable obstacle and no other. A stop is an end
/// that an obstacle, or land too narrow for the machine between obstacles (classify_obstacles(), with
/// `clearance_m`), begins within kAheadOfLine_m ahead of. A line that ends where it begins loses a tenth of a
/// millimetre.
///
/// Frame: the field's local metres. Throws kBadInput as validate_request(), where no line has a length, and
/// where no swath reaches the field. O(n log n) for n vertices of which few lie at one height.
PricedLines price_lines(const Field& field, const Machine& machine, const Objective& objective,
                        const GivenLines& lines, double clearance_m);

}  // namespace tramline
