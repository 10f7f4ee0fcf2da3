#pragma once
// The rows of a strip that no grid of a box drives.

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/cost/bound/row_cost_bound.h"
#include "tramline/geometry/interval.h"

namespace tramline {

/// The terms of driving a strip and of the boundary's moves in it.
struct DrivenTerms {
  double least_width_m = 0;  ///< of a row that may be driven
  double shortest_m = 0;     ///< least length of a driven piece
  double shear_m = 0;        ///< largest move of the strip's columns along
};

/// Stretches of a run (windows with land between them, and none before or beyond) that are in no piece,
/// wherever the boundary moves: too little of each of their rows lies inside, or they are too short for a
/// piece between such rows. Written to `out`, sorted, reaching a shear beyond the run. For end rules by
/// width, where no obstacle is near. O(p log p).
void find_undriven_rows(std::span<const BoundaryWindow> run, const RowBoundTerms& moving,
                        const DrivenTerms& driven, Intervals& out);

}  // namespace tramline
