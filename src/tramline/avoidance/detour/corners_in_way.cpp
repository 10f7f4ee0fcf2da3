#include "tramline/avoidance/detour/corners_in_way.h"

#include <algorithm>

namespace tramline {

bool extend(Parts& parts, std::size_t hazard, Interval range) {
  const auto [found, is_new] = parts.try_emplace(hazard, range);
  if (is_new) return true;
  const Interval before = found->second;
  found->second = {std::min(before.from, range.from), std::max(before.to, range.to)};
  return !(found->second == before);
}

void append_corners(const Ring& ring, Interval range, double bottom, double radius,
                    std::vector<KeepOut>& out) {
  const auto clipped = [](const Ring& in, auto height) {
    Ring kept;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Point a = in[i], b = in[i + 1 == in.size() ? 0 : i + 1];
      const double ha = height(a), hb = height(b);
      if (ha >= 0) kept.push_back(a);
      if ((ha >= 0) != (hb >= 0)) kept.push_back(a + (ha / (ha - hb)) * (b - a));
    }
    return kept;
  };
  Ring part = clipped(ring, [&](Point p) { return p.x - range.from; });
  part = clipped(part, [&](Point p) { return range.to - p.x; });
  part = clipped(part, [&](Point p) { return p.y - bottom; });
  for (const Point corner : part) out.push_back({corner, radius});
}

}  // namespace tramline
