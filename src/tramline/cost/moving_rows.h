#pragma once
// What the cross-sections of a strip cost at least when the boundary moves across.

#include <span>
#include <vector>

#include "tramline/cost/strip_parts.h"
#include "tramline/geometry/cross_section.h"
#include "tramline/model/objective.h"

namespace tramline {

/// constant + per_shift · e + per_turn · a, where the boundary at y moves across by e + a·(y − pivot).
struct AffineBound {
  double constant = 0;
  double per_shift = 0;
  double per_turn = 0;

  AffineBound& operator+=(const AffineBound& other);
  /// For all |e| ≤ shift, |a| ≤ turn.
  double least(double shift, double turn) const;
};

/// The terms of moving_rows().
struct MovingTerms {
  double width_m = 1;
  double over_price = 0;
  double under_price = 0;
  double pivot_along = 0;
  double turn = 0;   ///< |a| is no more
  double shift = 0;  ///< |e| is no more
};

/// A bound of ∫ min(λo·(w − m), λu·m) dy over the rows y of a window whose parts of the boundary are given,
/// m being how much of the row lies inside and within the strip. Where one part is all that may come into a
/// row, m changes just as that part moves, and min(…), which is concave, lies above its chord; other rows
/// are charged the least that `slabs`, the strip's profile, allows. O(p log p + p·(most parts in a row)).
AffineBound moving_rows(std::span<const BoundaryPart> parts, const std::vector<Slab>& slabs,
                        const MovingTerms& terms);

/// ∫ max(0, min(λo·(w − s − m), λu·(m − s))) dy over the profile between two places along.
double spared_rows(const std::vector<Slab>& slabs, double from, double to, double shift,
                   const MovingTerms& terms);

}  // namespace tramline
