#include "tramline/check/doubled_ground.h"

#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/box_grid.h"
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

void append_common(const Polygon& a, const Polygon& b, Region& out) {
  for (Polygon& both : common_ground(a, b))
    if (shows(area(both), perimeter(both.outer))) out.push_back(std::move(both));
}

}  // namespace

Region doubled_ground(const Region& swaths) {
  std::vector<Box> boxes;
  for (const Polygon& swath : swaths) boxes.push_back(bounds(swath));
  const BoxGrid grid(boxes);
  Region out;
  for (std::size_t i = 0; i < swaths.size(); ++i)
    grid.each_meeting(boxes[i], [&](std::size_t k) {
      if (k < i) append_common(swaths[k], swaths[i], out);
    });
  return out;
}

Region doubled_ground(const std::vector<WorkedPart>& parts, double width_m) {
  const BoxGrid grid = grid_of(parts);
  Region out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    grid.each_meeting(bounds(parts[i].ground), [&](std::size_t k) {
      if (k >= i || !may_meet(parts[k], parts[i], width_m)) return;
      for (const Polygon& a : parts[k].ground)
        for (const Polygon& b : parts[i].ground) append_common(a, b, out);
    });
  return out;
}

}  // namespace tramline::check
