#include "tramline/check/doubled_ground.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tramline/check/boxed.h"
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

Region doubled_ground(const Region& swaths) {
  BoxedRegion all = boxed(swaths);
  std::sort(all.begin(), all.end(), [](const Boxed& a, const Boxed& b) { return a.box.min_x < b.box.min_x; });
  Region out;
  for (auto a = all.begin(); a != all.end(); ++a)
    for (auto b = a + 1; b != all.end() && b->box.min_x <= a->box.max_x; ++b) {
      if (!intersects(a->box, b->box)) continue;
      for (Polygon& both : common_ground(*a->shape, *b->shape))
        if (shows(area(both), perimeter(both.outer))) out.push_back(std::move(both));
    }
  return out;
}

}  // namespace tramline::check
