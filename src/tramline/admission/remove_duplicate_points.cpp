#include "tramline/admission/remove_duplicate_points.h"

#include <fmt/format.h>

#include "tramline/admission/tolerances.h"

namespace tramline {

void remove_duplicate_points(WorkRing& ring, RepairLog& repair_log) {
  WorkRing kept;
  kept.name = ring.name;
  const auto note = [&](std::size_t i, int twin) {
    repair_log.repair(fmt::format("{} had vertex {} in the same place as vertex {}; one was removed",
                                  ring.name, ring.vertex[i], twin),
                      ring.place(i), ring.points[i], 0);
  };
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    if (!kept.points.empty() && distance(kept.points.back(), ring.points[i]) <= kSamePlace_m) {
      note(i, kept.vertex.back());
      continue;
    }
    kept.points.push_back(ring.points[i]);
    kept.vertex.push_back(ring.vertex[i]);
  }
  while (kept.points.size() > 1 && distance(kept.points.back(), kept.points.front()) <= kSamePlace_m) {
    repair_log.repair(fmt::format("{} had vertex {} in the same place as vertex {}; one was removed",
                                  ring.name, kept.vertex.back(), kept.vertex.front()),
                      kept.place(kept.points.size() - 1), kept.points.back(), 0);
    kept.erase(kept.points.size() - 1);
  }
  ring = std::move(kept);
}

}  // namespace tramline
