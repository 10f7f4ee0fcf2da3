#include "tramline/check/measure/worked_land.h"

#include "tramline/check/measure/overlay_cells.h"

namespace tramline::check {

WorkedLand worked_on(const Region& land, const std::vector<WorkedPart>& parts, std::size_t owners) {
  constexpr std::size_t kLand = 0;
  OverlayEdges overlay;
  overlay.add(land, kLand);
  for (std::size_t i = 0; i < parts.size(); ++i) overlay.add(parts[i].ground, i + 1);
  WorkedLand out;
  out.useful_m2.assign(owners, 0);
  each_cell(overlay, [&](const OverlayCell& cell) {
    if (cell.covers.front().shape != kLand || cell.covers.size() < 2) return;
    out.useful_m2[parts[cell.covers[1].shape - 1].piece] += cell.area_m2;
    out.covered_m2 += cell.area_m2;
  });
  return out;
}

}  // namespace tramline::check
