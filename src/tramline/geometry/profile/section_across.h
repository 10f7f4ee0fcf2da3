#pragma once
// Where a boundary edge crosses the cross-sections of a segment.

#include "tramline/geometry/profile/path_profile.h"

namespace tramline {

/// How far from the left end of the cross-section the part crosses it, m; beyond the part's ends as at them.
/// `half_width` is that of the profile, `along` a position along the segment.
double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along);

}  // namespace tramline
