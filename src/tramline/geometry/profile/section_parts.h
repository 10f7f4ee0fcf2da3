#pragma once
// Boundary edges as parts of a segment's cross-sections.

#include <vector>

#include "tramline/geometry/path/segment_frame.h"
#include "tramline/geometry/profile/path_profile.h"

namespace tramline {

/// Distance from the left end of the cross-section at which the part crosses it, m; beyond the part's ends as
/// at them. `half_width` is that of the profile, `along` a position along the segment.
double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along);

/// A crossing of the boundary with the right ends of the cross-sections.
struct RightCrossing {
  double along;
  int change;  ///< +1: the region begins there
};

struct RightEnds {
  std::vector<RightCrossing> crossings;
  bool near_start = false;  ///< the right ends cross an edge there, if not in the segment next to this one
  bool near_end = false;
};

/// Appends the parts of all edges near the segment, in order. `out` knows its shape; `near` is for scratch.
RightEnds add_section_parts(const EdgeIndex& region, const SegmentFrame& frame, double width_m,
                            std::vector<std::size_t>& near, SegmentProfile& out);

}  // namespace tramline
