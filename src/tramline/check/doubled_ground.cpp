#include "tramline/check/doubled_ground.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "tramline/check/boxed.h"
#include "tramline/check/path_distance.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/convex_clip.h"

namespace tramline::check {
namespace {

bool shows(double area_m2, double perimeter_m) { return area_m2 > kThinnestShown_m * perimeter_m; }

bool is_rectangle(const Polygon& swath) { return swath.outer.size() == 4 && swath.holes.empty(); }

/// Most pairs lie side by side and have nothing in common: that can be told without an overlay.
Region common_ground(const Polygon& a, const Polygon& b) {
  if (!is_rectangle(b)) return is_rectangle(a) ? common_ground(b, a) : intersection({a}, {b});
  if (is_rectangle(a)) {
    Ring both = convex_intersection(a.outer, b.outer);
    return both.empty() ? Region{} : Region{{std::move(both), {}}};
  }
  const double common_m2 = signed_area(clipped(RingSet{a.outer}, convex_set(b.outer)));
  return common_m2 > kThinnestShown_m * kThinnestShown_m ? intersection({a}, {b}) : Region{};
}

}  // namespace

Region doubled_ground(const Region& swaths) { return doubled_ground(swaths, {}, 0); }

Region doubled_ground(const Region& swaths, const std::vector<Path>& lines, double width_m) {
  const BoxedRegion all = boxed(swaths);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&all](std::size_t a, std::size_t b) { return all[a].box.min_x < all[b].box.min_x; });
  Region out;
  for (auto a = order.begin(); a != order.end(); ++a)
    for (auto b = a + 1; b != order.end() && all[*b].box.min_x <= all[*a].box.max_x; ++b) {
      if (!intersects(all[*a].box, all[*b].box)) continue;
      if (!lines.empty() && distance_between(lines[*a], lines[*b]) > width_m - kThinnestShown_m) continue;
      for (Polygon& both : common_ground(*all[*a].shape, *all[*b].shape))
        if (shows(area(both), perimeter(both.outer))) out.push_back(std::move(both));
    }
  return out;
}

}  // namespace tramline::check
