#include "tramline/cost/bound/detour_length.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tramline {

std::vector<SeenPoint> upper_hull(std::vector<SeenPoint> points) {
  std::sort(points.begin(), points.end(), [](const SeenPoint& a, const SeenPoint& b) {
    return a.along < b.along || (a.along == b.along && a.aside < b.aside);
  });
  std::vector<SeenPoint> out;
  for (const SeenPoint& p : points) {
    const auto bends_down = [&] {
      const SeenPoint &a = out[out.size() - 2], &b = out.back();
      return (b.along - a.along) * (p.aside - a.aside) - (b.aside - a.aside) * (p.along - a.along) < 0;
    };
    while (out.size() >= 2 && !bends_down()) out.pop_back();
    if (!out.empty() && out.back().along == p.along) out.pop_back();
    out.push_back(p);
  }
  return out;
}

double least_longer_m(const std::vector<SeenPoint>& points, double half_width_m, const Interval& rows) {
  // Places on the far side of the disc of half a width about a point: all of them lie under the path.
  constexpr double kCosines[] = {0.5, 0.8660254037844386};
  std::vector<SeenPoint> under{{rows.from, 0}, {rows.to, 0}};
  for (const SeenPoint& p : upper_hull(points)) {
    under.push_back({p.along, p.aside + half_width_m});
    for (const double up : kCosines) {
      const double across = std::sqrt((1 - up) * (1 + up));
      for (const double along : {-across, across})
        under.push_back({p.along + half_width_m * along, p.aside + half_width_m * up});
    }
  }
  std::erase_if(under,
                [&](const SeenPoint& p) { return p.aside < 0 || p.along < rows.from || p.along > rows.to; });
  const std::vector<SeenPoint> hull = upper_hull(std::move(under));
  double length_m = 0;
  for (std::size_t i = 1; i < hull.size(); ++i)
    length_m += std::hypot(hull[i].along - hull[i - 1].along, hull[i].aside - hull[i - 1].aside);
  return std::max(0.0, length_m - rows.length());
}

}  // namespace tramline
