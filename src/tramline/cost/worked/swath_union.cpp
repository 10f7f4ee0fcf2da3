#include "tramline/cost/worked/swath_union.h"

#include <iterator>
#include <span>
#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// Land apart from each other's boxes has nothing in common that an overlay could dissolve.
Region joined(Region a, Region b) {
  if (a.empty() || b.empty() || !intersects(bounds(a), bounds(b))) {
    a.insert(a.end(), std::make_move_iterator(b.begin()), std::make_move_iterator(b.end()));
    return a;
  }
  return unite(a, b);
}

SwathUnion union_of(std::span<const Polygon> swaths) {
  if (swaths.size() <= 1) return {{swaths.begin(), swaths.end()}, {}};
  const std::size_t half = swaths.size() / 2;
  SwathUnion a = union_of(swaths.first(half)), b = union_of(swaths.subspan(half));
  Region both = common_land(a.all, b.all);
  return {joined(std::move(a.all), std::move(b.all)),
          joined(joined(std::move(a.doubled), std::move(b.doubled)), std::move(both))};
}

}  // namespace

Region common_land(const Region& a, const Region& b) {
  if (a.empty() || b.empty() || !intersects(bounds(a), bounds(b))) return {};
  Region out = intersection(a, b);
  std::erase_if(out, is_sliver);
  return out;
}

SwathUnion swath_union(const Region& swaths) { return union_of(swaths); }

Region united_regions(std::vector<Region> regions) {
  std::erase_if(regions, [](const Region& region) { return region.empty(); });
  for (; regions.size() > 1; regions.resize((regions.size() + 1) / 2))
    for (std::size_t i = 0; 2 * i < regions.size(); ++i) {
      Region next = std::move(regions[2 * i]);
      if (2 * i + 1 < regions.size()) next = joined(std::move(next), std::move(regions[2 * i + 1]));
      regions[i] = std::move(next);
    }
  return regions.empty() ? Region{} : std::move(regions.front());
}

}  // namespace tramline
