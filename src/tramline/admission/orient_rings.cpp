#include "tramline/admission/orient_rings.h"

#include <fmt/format.h>

#include <algorithm>

namespace tramline {

void orient_rings(std::vector<WorkRing>& rings, RingWinding winding, RepairLog& repair_log) {
  if (rings.empty()) return;
  const bool outer_clockwise = signed_area(rings[0].points) < 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const double turning = signed_area(rings[r].points);
    if (turning == 0) continue;
    const bool clockwise = turning < 0;
    const bool like_outer = r > 0 && clockwise == outer_clockwise;
    const bool against_format = winding == RingWinding::kPrescribed && clockwise == (r == 0);
    if (like_outer)
      repair_log.repair(
          fmt::format("{} ran the same way round as the outer ring; it was taken as a hole", rings[r].name),
          rings[r].name, rings[r].points.front(), 0);
    else if (against_format)
      repair_log.repair(fmt::format("{} ran {}, against the file format; it was turned round", rings[r].name,
                                    clockwise ? "clockwise" : "counter-clockwise"),
                        rings[r].name, rings[r].points.front(), 0);
    if (clockwise == (r == 0)) {
      std::reverse(rings[r].points.begin(), rings[r].points.end());
      std::reverse(rings[r].vertex.begin(), rings[r].vertex.end());
    }
  }
}

}  // namespace tramline
