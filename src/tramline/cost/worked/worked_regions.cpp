#include "tramline/cost/worked/worked_regions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/cost/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline {
namespace {

bool is_rectangle(const Ring& swath) { return swath.size() == 4; }

bool worth_keeping(double area_m2, const Ring& around) {
  return area_m2 > kThinnestOverlap_m * perimeter(around);
}

/// Whether a ring turns left at every vertex and winds once: it does not cross itself.
bool is_strictly_convex(const Ring& ring) {
  int rises = 0;  // changes of its edges from going down to going up
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
    if (!(cross(in, out) > 0)) return false;
    if (in.y < 0 && out.y >= 0) ++rises;
  }
  return rises == 1;
}

/// The intersection of two convex rings as a polygon that overlays accept. Vertices that nearly coincide may
/// have changed places, so that the ring crosses itself, and an overlay would drop its land without a word.
Region sound(Ring both) {
  if (is_strictly_convex(both) || !find_invalidity({both, {}})) return {{std::move(both), {}}};
  return convex_hull(both);
}

/// Where one of two is a rectangle, the area of their intersection is found without building it.
Region overlap_of(const Ring& a, const Ring& b) {
  if (is_rectangle(b)) {
    Ring both = convex_intersection(a, b);
    if (!worth_keeping(std::abs(signed_area(both)), both)) return {};
    if (is_rectangle(a)) return sound(std::move(both));
  } else if (is_rectangle(a)) {
    return overlap_of(b, a);
  }
  return intersection({{a, {}}}, {{b, {}}});
}

}  // namespace

Region common_to_two(const Region& swaths) {
  // Sorted along x, so that only near ones are met.
  struct Item {
    const Ring* ring;
    Box box;
  };
  std::vector<Item> items;
  for (const Polygon& swath : swaths) items.push_back({&swath.outer, bounds(swath)});
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.box.min_x < b.box.min_x; });
  Region out;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = i + 1; j < items.size() && items[j].box.min_x <= items[i].box.max_x; ++j) {
      if (!intersects(items[i].box, items[j].box)) continue;
      for (Polygon& both : overlap_of(*items[i].ring, *items[j].ring))
        if (worth_keeping(area(both), both.outer)) out.push_back(std::move(both));
    }
  return out;
}

WorkedRegions worked_regions(const Region& body, const Region& swaths) {
  return worked_regions(body, swaths, std::vector<Region>{unite(swaths)});
}

WorkedRegions worked_regions(const Region& body, const Region& swaths, const std::vector<Region>& grounds) {
  Region worked;
  for (const Region& ground : grounds) worked = worked.empty() ? ground : unite(worked, ground);
  Region overlap = difference(worked, body);
  if (const Region doubled = common_to_two(swaths); !doubled.empty())
    overlap = unite(overlap, unite(doubled));
  return {std::move(overlap), difference(body, worked)};
}

}  // namespace tramline
