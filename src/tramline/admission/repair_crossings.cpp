#include "tramline/admission/repair_crossings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/admission/disputed_land.h"
#include "tramline/admission/ring_crossings.h"
#include "tramline/admission/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline {
namespace {

/// More crossings than this are no slip of the hand, and each takes time with every other to sort out.
constexpr std::size_t kMostCrossings = 2000;

void refuse_tangles(const WorkRing& ring, Point first, const RepairLog& repair_log) {
  if (ring_crossings(ring.points, kMostCrossings) > kMostCrossings)
    throw repair_log.refusal(
        fmt::format("the {} crosses itself more than {} times, at {} and elsewhere; redraw or "
                    "smooth it so that it goes round the field once",
                    ring.name, kMostCrossings, repair_log.shown(first)));
}

void refuse_guessing(const WorkRing& ring, const Region& disputed, double enclosed_m2,
                     const RepairLog& repair_log) {
  const double disputed_m2 = area(disputed);
  if (disputed_m2 <= guess_limit_m2(enclosed_m2)) return;
  const auto largest = std::max_element(disputed.begin(), disputed.end(),
                                        [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  throw repair_log.refusal(
      fmt::format("the {} goes round {:.1f} m² near {} more than once, so it is unclear whether that land "
                  "belongs to the field; redraw it there",
                  ring.name, disputed_m2, repair_log.shown(interior_point(*largest))));
}

void drop_small_lobes(Region& lobes, const WorkRing& ring, double limit_m2, double sign,
                      RepairLog& repair_log) {
  while (lobes.size() > 1 && area(lobes.back()) <= limit_m2) {
    const double lobe_m2 = area(lobes.back());
    repair_log.repair(fmt::format("{} cut off a lobe of {:.3f} m² by crossing itself; the lobe was removed",
                                  ring.name, lobe_m2),
                      ring.name, interior_point(lobes.back()), -sign * lobe_m2);
    lobes.pop_back();
  }
}

}  // namespace

Region repair_crossings(const WorkRing& ring, RingRole role, RepairLog& repair_log) {
  assert(ring.points.size() >= 3);
  const auto fault = find_invalidity({ring.points, {}});
  if (!fault) return {oriented({ring.points, {}})};
  const double sign = role == RingRole::kHole ? -1 : 1;
  const double drawn_m2 = std::abs(signed_area(ring.points));
  refuse_tangles(ring, fault->place, repair_log);
  Region lobes = made_valid({ring.points, {}});
  std::erase_if(lobes, [](const Polygon& lobe) { return area(lobe) <= 0; });
  std::stable_sort(lobes.begin(), lobes.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  const double enclosed_m2 = area(lobes);
  refuse_guessing(ring, disputed_land(ring.points), enclosed_m2, repair_log);
  repair_log.repair(
      fmt::format("{} touched or crossed itself; the land it goes round an odd number of times was kept",
                  ring.name),
      ring.name, fault->place, sign * (enclosed_m2 - drawn_m2));
  // A hole's lobes all keep the machine out, however small.
  drop_small_lobes(lobes, ring, role == RingRole::kHole ? kNoArea_m2 : guess_limit_m2(enclosed_m2), sign,
                   repair_log);
  return lobes;
}

}  // namespace tramline
