#include "tramline/geometry/profile/section_across.h"

#include <algorithm>
#include <cmath>

namespace tramline {

double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along) {
  if (along <= part.from) return part.across_from;
  if (along >= part.to) return part.across_to;
  if (segment.radius == 0)
    return part.across_from +
           (part.across_to - part.across_from) * ((along - part.from) / (part.to - part.from));
  const double angle = along / segment.radius - segment.half_turn;
  const double radius = part.moment / (std::cos(angle) * part.edge.y - std::sin(angle) * part.edge.x);
  const double across = segment.sense * (radius - segment.radius) + half_width;
  const auto [low, high] = std::minmax(part.across_from, part.across_to);
  return across >= low ? std::min(across, high) : low;  // NaN: low
}

}  // namespace tramline
