#include "tramline/planner/search/best_along.h"

#include <utility>

#include "tramline/cost/bound/best_offset.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/search/grid_pricing.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

/// The cheapest offset of all over land without obstacles; with obstacles, of those tracks are cut at.
double cheapest_origin(const SearchTask& task, const Subfield& subfield, double known_m,
                       const SearchContext& context) {
  const GridPricing pricing(task, subfield.shape, context);
  const GridTally tally = pricing.tally(subfield.direction.angle().radians());
  const PricedOrigin known{known_m, separate_cost(task.objective, tally.at(known_m))};
  return best_offset(tally, pricing.bound(), known, near_enough(context)).origin_m;
}

/// The origins to try: those of Versleijen §2.2.1 and, if the strategy looks for more, the cheapest of all
/// and others between, since the position of tracks relative to an obstacle determines the cost of detours.
std::vector<double> origins_to_try(const SearchTask& task, const Subfield& subfield,
                                   const SearchContext& context) {
  std::vector<double> out;
  for (const StripGrid& grid : strip_grids(subfield, task.machine.width_m)) out.push_back(grid.origin_m);
  if (task.settings.strategy == Strategy::kSweep) return out;
  const double cheapest_m = cheapest_origin(task, subfield, out.front(), context);
  out.insert(out.begin(), cheapest_m);
  const int steps = context.wants_bound() ? 8 : 2;
  if (!task.ground.hazards.empty())
    for (int k = 1; k < steps; ++k) out.push_back(cheapest_m + task.machine.width_m * k / steps);
  return out;
}

}  // namespace

LinedSubfield best_along(const SearchTask& task, Subfield subfield, const SearchContext& context) {
  const std::vector<double> origins = origins_to_try(task, subfield, context);
  std::vector<Candidate> candidates(origins.size());
  for_each_index(origins.size(), context, [&](std::size_t i) {
    candidates[i] = candidate_on(task, {{subfield, origins[i]}});
  });
  std::size_t best = 0;
  for (std::size_t i = 1; i < origins.size(); ++i)
    if (is_better(candidates[i].avoided, candidates[best].avoided)) best = i;
  return {std::move(subfield), origins[best]};
}

}  // namespace tramline
