#pragma once
// Boundary edges as parts of a segment's cross-sections.

#include <vector>

#include "tramline/geometry/path/segment_frame.h"
#include "tramline/geometry/profile/path_profile.h"

namespace tramline {

/// Distance from the left end of the cross-section at which the part crosses it, m. Before the part's
/// beginning and after its end, the value is that of the nearer end. `half_width` is that of the profile,
/// `along` a position along the segment.
double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along);

/// A crossing of the boundary with the right ends of the cross-sections.
struct RightCrossing {
  double along;
  int change;  ///< +1: the region begins there
};

struct RightEnds {
  std::vector<RightCrossing> crossings;
  /// An edge crosses the right ends within kTouch_m of the segment's start: the crossing may belong to the
  /// segment before instead.
  bool near_start = false;
  bool near_end = false;  ///< the same at its end, for the segment after
};

/// Appends the parts of all edges near the segment, in order. `out` already holds the segment's
/// shape; `near` is working memory, whose content is overwritten.
RightEnds add_section_parts(const EdgeIndex& region, const SegmentFrame& frame, double width_m,
                            std::vector<std::size_t>& near, SegmentProfile& out);

}  // namespace tramline
