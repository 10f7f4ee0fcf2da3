#include "tramline/coverage/gaps.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline::coverage {

std::vector<Gap> gaps_of(const Region& missed) {
  std::vector<Gap> gaps;
  for (const Polygon& polygon : missed)
    if (const double area_m2 = area(polygon); area_m2 >= kLeastGap_m2)
      gaps.push_back(
          {0, polygon, area_m2, interior_point(polygon), std::numeric_limits<double>::quiet_NaN()});
  const auto key = [](const Gap& gap) { return std::tuple(-gap.area_m2, gap.centre.x, gap.centre.y); };
  std::sort(gaps.begin(), gaps.end(), [&](const Gap& a, const Gap& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    gaps[i].number = static_cast<int>(i) + 1;
    if (i >= kMeasuredGaps) continue;
    const Disc widest = largest_disc(gaps[i].shape, kGapWidth_m / 2);
    gaps[i].centre = widest.centre;
    gaps[i].widest_m = 2 * widest.radius_m;
  }
  return gaps;
}

}  // namespace tramline::coverage
