#pragma once
// Stretches of a segment over which the same parts of the boundary are met.

#include "tramline/geometry/profile/section_parts.h"

namespace tramline {

/// What is inside where the last segment ended; what is inside goes on from there.
struct SectionBefore {
  int right_inside = -1;  ///< negative: not known
  double inside_m = 0;
};

/// Puts the slabs of a segment together from its parts and what its right ends cross, and says what is inside
/// at their right ends.
void add_section_slabs(const EdgeIndex& region, const SegmentFrame& frame, double width_m, RightEnds right,
                       SectionBefore& before, SegmentProfile& out);

}  // namespace tramline
