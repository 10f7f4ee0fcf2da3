#include "tramline/admission/clip_holes.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/admission/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline {
namespace {

bool strictly_inside(const Ring& outer, const Obstacle& hole) {
  return contains(outer, hole.shape.outer.front()) && distance_to_ring({hole.shape}, outer) > kSamePlace_m;
}

Region part_inside(const Ring& outer, const Region& hole) {
  if (!intersects(bounds(outer), bounds(hole))) return {};
  Region inside = intersection(hole, {{outer, {}}});
  std::erase_if(inside, [](const Polygon& piece) { return area(piece) <= kNoArea_m2; });
  return inside;
}

void note(const std::vector<Ring>& outers, const Obstacle& hole, double inside_m2, RepairLog& repair_log) {
  const double hole_m2 = area(hole.shape), outside_m2 = hole_m2 - inside_m2;
  if (inside_m2 <= kNoArea_m2) {
    repair_log.repair(fmt::format("{} lies outside the outer ring; it was dropped", hole.origin), hole.origin,
                      interior_point(hole.shape), hole_m2);
    return;
  }
  if (outside_m2 > kNoArea_m2) {
    Region outside = {hole.shape};
    for (const Ring& outer : outers) outside = difference(outside, {{outer, {}}});
    repair_log.repair(
        fmt::format("{} reached outside the outer ring; the outside part was removed", hole.origin),
        hole.origin, outside.empty() ? hole.shape.outer.front() : interior_point(outside.front()),
        outside_m2);
    return;
  }
  for (const Ring& outer : outers) {
    const auto fault = find_invalidity({outer, {hole.shape.outer}});
    if (!fault) continue;
    repair_log.repair(
        fmt::format("{} shares an edge with the outer ring; it was kept as an obstacle at the edge",
                    hole.origin),
        hole.origin, fault->place, 0);
    return;
  }
  repair_log.warn(fmt::format("{} touches the outer ring", hole.origin));
}

}  // namespace

std::vector<std::vector<Obstacle>> clip_holes(const std::vector<Ring>& outers,
                                              const std::vector<Obstacle>& holes, RepairLog& repair_log) {
  std::vector<std::vector<Obstacle>> out(outers.size());
  for (const Obstacle& hole : holes) {
    const auto home = std::find_if(outers.rbegin(), outers.rend(),
                                   [&](const Ring& outer) { return strictly_inside(outer, hole); });
    if (home != outers.rend()) {
      out[static_cast<std::size_t>(outers.rend() - home) - 1].push_back(hole);
      continue;
    }
    double inside_m2 = 0;
    Region rest = {hole.shape};
    for (std::size_t k = outers.size(); k-- > 0;) {
      for (Polygon& piece : part_inside(outers[k], rest)) {
        inside_m2 += area(piece);
        out[k].push_back({std::move(piece), hole.kind, hole.origin});
      }
      if (k > 0) rest = difference(rest, {{outers[k], {}}});
    }
    note(outers, hole, inside_m2, repair_log);
  }
  return out;
}

}  // namespace tramline
