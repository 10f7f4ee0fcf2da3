#include "tramline/planner/curved_overlaps.h"

#include <algorithm>

#include "tramline/cost/gain_by_detours.h"
#include "tramline/cost/kinked_overlap.h"

namespace tramline {

void add_overlaps(Plan& plan) {
  const double width_m = plan.machine.width_m;
  if (plan.settings.tracks == TrackConstruction::kPaper) {
    const std::vector<double> overlaps = overlap_by_kinked_piece(plan.body, plan.pieces, width_m);
    for (std::size_t i = 0; i < overlaps.size(); ++i) plan.pieces[i].overlap_m2 = overlaps[i];
    return;
  }
  const std::vector<double> gains = gain_by_detours_m2(plan.body, plan.pieces, width_m);
  for (std::size_t i = 0; i < gains.size(); ++i)
    plan.pieces[i].overlap_m2 = std::max(0.0, *plan.pieces[i].overlap_m2 - gains[i]);
}

}  // namespace tramline
