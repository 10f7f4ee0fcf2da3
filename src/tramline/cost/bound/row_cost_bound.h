#pragma once
// What the cross-sections of a strip cost at least when the boundary moves across.

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
  /// For all |e| ≤ shift, |a| ≤ turn.
  double least(double shift, double turn) const;
  double most(double shift, double turn) const;
};

/// The terms of row_cost_bound().
struct RowBoundTerms {
  double width_m = 1;
  double over_price = 0;
  double under_price = 0;
  double pivot_along = 0;
  double turn = 0;   ///< |a| is no more
  double shift = 0;  ///< |e| is no more
};

/// Two bounds of ∫ min(λo·(w − m), λu·m) dy over some rows y, m being how much of the row lies inside and
/// within the strip.
struct RowBounds {
  double apart = 0;      ///< every row at its least: m may change by as much as the boundary moves
  AffineBound together;  ///< all rows moved at once
};

/// How far the boundary may move between two places along.
double most_shift(double from, double to, const RowBoundTerms& terms);

/// How much land lies in the strip in those rows, at least, m².
double inside_rows(std::span<const BoundaryPart> parts, const RowBoundTerms& terms);

/// Of the rows of a window whose parts of the boundary are given, sorted by their lowest place. Where one
/// part is all that may come into a row, m changes just as that part moves, and min(…), which is concave,
/// lies above its chord. Rows in the `undriven` stretches (sorted) cost λu·m. O(p log p + p·(most parts in a
/// row)).
RowBounds row_cost_bound(std::span<const BoundaryPart> parts, const RowBoundTerms& terms,
                         std::span<const Interval> undriven = {});

}  // namespace tramline
