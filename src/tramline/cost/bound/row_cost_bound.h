#pragma once
// A lower bound on the cost of a strip's cross-sections when the boundary moves across.

#include <span>
#include <vector>

#include "tramline/cost/bound/strip_parts.h"
#include "tramline/geometry/interval.h"

namespace tramline {

/// constant + per_shift · e + per_turn · a, where the boundary at y moves across by e + a·(y − pivot).
struct AffineBound {
  double constant = 0;
  double per_shift = 0;
  double per_turn = 0;

  AffineBound& operator+=(const AffineBound& other);
  AffineBound& operator-=(const AffineBound& other);
  /// Bounds for all |e| ≤ shift, |a| ≤ turn.
  double least(double shift, double turn) const;
  double most(double shift, double turn) const;
};

/// The terms of row_cost_bound().
struct RowBoundTerms {
  double width_m = 1;
  double over_price = 0;
  double under_price = 0;
  double pivot_along = 0;
  double turn = 0;   ///< largest |a|
  double shift = 0;  ///< largest |e|
};

/// Two bounds of ∫ min(λo·(w − m), λu·m) dy over some rows y, with m the length of the row inside the region
/// and within the strip.
struct RowBounds {
  double apart = 0;      ///< every row at its least: m may change by as much as the boundary moves
  AffineBound together;  ///< all rows moved at once
};

/// Largest move of the boundary between two coordinates along.
double most_shift(double from, double to, const RowBoundTerms& terms);

/// Least area of land in the strip in those rows, m².
double inside_rows(std::span<const BoundaryPart> parts, const RowBoundTerms& terms);

/// Bounds of the rows of a window with these parts of the boundary, sorted by their lowest coordinate. Where
/// only one part can reach a row, m changes just as that part moves, and min(…), which is concave, lies above
/// its chord. Rows in the `undriven` stretches (sorted) cost λu·m. O(p log p + p·(most parts in a row)).
RowBounds row_cost_bound(std::span<const BoundaryPart> parts, const RowBoundTerms& terms,
                         std::span<const Interval> undriven = {});

}  // namespace tramline
