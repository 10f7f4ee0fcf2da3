#include <optional>

#include "tramline/geometry/error.h"
#include "tramline/planner/curved_plan.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/reference_chains.h"

namespace tramline {

std::optional<CurvedCandidate> best_curved(const SearchTask& task, int threads) {
  constexpr std::size_t kMostChains = 8;
  const double width_m = task.machine.width_m;
  const double corner_m = 2 * std::max(task.machine.radius_m, 0.5 * width_m);
  const double smoothing[] = {0.02 * width_m, 0.1 * width_m, 0.5 * width_m};
  const auto chains = reference_chains(task.ground.plannable, corner_m, 0.1 * width_m, kMostChains);
  const std::size_t levels = std::size(smoothing);
  std::vector<std::optional<CurvedCandidate>> found(chains.size() * levels);
  for_each_index(found.size(), threads, [&](std::size_t i) {
    try {
      found[i] = curved_along(task, chains[i / levels], smoothing[i % levels]);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;  // no line to drive along
    }
  });
  std::optional<CurvedCandidate> best;
  for (std::optional<CurvedCandidate>& one : found) {
    if (!one || one->tally.pieces == 0 || (best && one->cost >= best->cost)) continue;
    best = std::move(one);
  }
  return best;
}

}  // namespace tramline
