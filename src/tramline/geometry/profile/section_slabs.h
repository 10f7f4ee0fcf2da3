#pragma once
// Stretches of a segment whose cross-sections cross the same parts of the boundary.

#include "tramline/geometry/profile/section_parts.h"

namespace tramline {

/// What is inside at the end of the segment before, from which this one goes on.
struct SectionBefore {
  int right_inside = -1;  ///< negative: not known
  double inside_m = 0;
};

/// Appends the slabs of a segment, made from its parts and the crossings of its right ends, and determines
/// what is inside at their right ends.
void add_section_slabs(const EdgeIndex& region, const SegmentFrame& frame, double width_m, RightEnds right,
                       SectionBefore& before, SegmentProfile& out);

}  // namespace tramline
