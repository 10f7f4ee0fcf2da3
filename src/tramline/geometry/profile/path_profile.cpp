#include "tramline/geometry/profile/path_profile.h"

#include <cassert>
#include <utility>

#include "tramline/geometry/profile/section_parts.h"
#include "tramline/geometry/profile/section_slabs.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

PathProfile path_profile(const EdgeIndex& region, const Path& path, double width_m) {
  assert(2 * smallest_radius(path) >= width_m * (1 - kPathRadius_share));
  PathProfile out{width_m, {}};
  out.segments.reserve(path.size());
  std::vector<std::size_t> near;
  SectionBefore before;
  double start = 0;
  for (const PathSegment& segment : path) {
    const SegmentFrame frame(segment, 0.5 * width_m);
    SegmentProfile profile;
    profile.start = start;
    profile.length = frame.length();
    profile.radius = frame.radius();
    profile.sense = frame.sense();
    profile.half_turn = frame.half_turn();
    RightEnds right = add_section_parts(region, frame, width_m, near, profile);
    add_section_slabs(region, frame, width_m, std::move(right), before, profile);
    start += profile.length;
    out.segments.push_back(std::move(profile));
  }
  return out;
}

}  // namespace tramline
