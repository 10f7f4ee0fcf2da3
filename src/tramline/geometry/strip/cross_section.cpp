#include "tramline/geometry/strip/cross_section.h"

#include <algorithm>

#include "tramline/geometry/strip/strip_fold.h"

namespace tramline {

std::vector<StripProfile> cross_sections(const Region& turned, const StripGrid& grid, StripRange range,
                                         const StripMask& wanted) {
  std::vector<StripProfile> profiles(static_cast<std::size_t>(range.size()));
  if (turned.empty()) return profiles;
  thread_local StripFold fold;
  fold.fold(std::span<const Polygon>(turned), grid, range, wanted);
  for (std::size_t i = 0; i < profiles.size(); ++i)
    if (wanted.empty() || wanted[i]) profiles[i] = fold.profile(i);
  return profiles;
}

Intervals where_at_least(const StripProfile& profile, double width_m) {
  Intervals out;
  for (const Slab& slab : profile.slabs) {
    const bool at_from = slab.width_from >= width_m, at_to = slab.width_to >= width_m;
    if (!at_from && !at_to) continue;
    Interval part{slab.from, slab.to};
    if (at_from != at_to) {
      const double share = (width_m - slab.width_from) / (slab.width_to - slab.width_from);
      const double turning_point = slab.from + share * (slab.to - slab.from);
      (at_from ? part.to : part.from) = turning_point;
    }
    if (part.from < part.to) append_joining(out, part);
  }
  return out;
}

double area_between(const StripProfile& profile, double from, double to) {
  double sum = 0;
  auto slab = std::partition_point(profile.slabs.begin(), profile.slabs.end(),
                                   [from](const Slab& below) { return below.to <= from; });
  for (; slab != profile.slabs.end() && slab->from < to; ++slab) {
    const double lo = std::max(from, slab->from), hi = std::min(to, slab->to);
    if (lo < hi) sum += 0.5 * (slab->width_at(lo) + slab->width_at(hi)) * (hi - lo);
  }
  return sum;
}

}  // namespace tramline
