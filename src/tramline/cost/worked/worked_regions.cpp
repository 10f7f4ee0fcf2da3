#include "tramline/cost/worked/worked_regions.h"

#include <algorithm>

#include "tramline/cost/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline {
namespace {

bool is_rectangle(const Ring& swath) { return swath.size() == 4; }

bool worth_keeping(double area_m2, const Ring& around) {
  return area_m2 > kThinnestOverlap_m * perimeter(around);
}

/// Where one of two is a rectangle, the area of their intersection is found without building it.
Region overlap_of(const Ring& a, const Ring& b) {
  if (is_rectangle(b)) {
    Ring both = convex_intersection(a, b);
    if (!worth_keeping(std::abs(signed_area(both)), both)) return {};
    if (is_rectangle(a)) return {{std::move(both), {}}};
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
