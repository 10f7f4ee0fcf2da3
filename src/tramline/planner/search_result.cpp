#include "tramline/planner/search_result.h"

namespace tramline {

SeenPlan seen_plan(const Candidate& candidate) {
  SeenPlan out{{}, {}, candidate.avoided.tally, candidate.cost()};
  for (std::size_t i = 0; i < candidate.subfields.size(); ++i) {
    out.lined_subfields.push_back({candidate.subfields[i], candidate.families[i].grid.origin_m});
    if (!candidate.avoided.tracks[i].pieces.empty())
      out.directions.push_back(candidate.subfields[i].direction);
  }
  return out;
}

}  // namespace tramline
