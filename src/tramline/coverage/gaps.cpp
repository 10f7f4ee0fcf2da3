#include "tramline/coverage/gaps.h"

#include <algorithm>
#include <tuple>

#include "tramline/geometry/boolean.h"

namespace tramline::coverage {

std::vector<Gap> gaps_of(const Region& missed) {
  std::vector<Gap> gaps;
  for (const Polygon& polygon : missed) {
    const double area_m2 = area(polygon);
    if (area_m2 < kLeastGap_m2) continue;
    const Disc widest = largest_disc(polygon, kGapWidth_m / 2);
    gaps.push_back({0, polygon, area_m2, widest.centre, 2 * widest.radius_m});
  }
  const auto key = [](const Gap& gap) { return std::tuple(-gap.area_m2, gap.centre.x, gap.centre.y); };
  std::sort(gaps.begin(), gaps.end(), [&](const Gap& a, const Gap& b) { return key(a) < key(b); });
  int number = 0;
  for (Gap& gap : gaps) gap.number = ++number;
  return gaps;
}

}  // namespace tramline::coverage
