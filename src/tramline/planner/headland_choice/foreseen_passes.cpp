#include "tramline/planner/headland_choice/foreseen_passes.h"

#include <algorithm>
#include <limits>

#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/needed_passes.h"
#include "tramline/planner/headland_choice/shortened_tracks.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/route/turning/turning_land.h"

namespace tramline {
namespace {

/// So many times passes are added. Each time the ends of tracks move.
constexpr int kMostForesights = 8;

}  // namespace

int deepest(const PassesByBoundary& passes) {
  int out = 0;
  for (const int n : passes.edges) out = std::max(out, n);
  for (const int n : passes.obstacles) out = std::max(out, n);
  return out;
}

PassesByBoundary sum_of(PassesByBoundary passes, const PassesByBoundary& more, int most) {
  const auto add = [most](std::vector<int>& to, const std::vector<int>& added) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = std::max(to[i], std::min(to[i] + added[i], most));
  };
  add(passes.edges, more.edges);
  add(passes.obstacles, more.obstacles);
  return passes;
}

int turns_without_room(const Plan& plan) {
  return static_cast<int>(std::count_if(plan.turns.begin(), plan.turns.end(), [](const PlannedTurn& turn) {
    return turn.state == TurnState::kNoRoom;
  }));
}

PassesByBoundary foreseen_passes(const PlanningProblem& problem, const Plan& layout, PassesByBoundary passes,
                                 int most, const SearchContext& context) {
  if (deepest(passes) == 0) return passes;
  const AllowedLand land(
      turning_land(problem.field, problem.machine, problem_with(problem, passes).settings));
  Plan plan = layout;
  PassesByBoundary best = passes;
  int fewest = std::numeric_limits<int>::max();
  for (int round = 0; round < kMostForesights; ++round) {
    context.report();
    plan.pieces = shortened_tracks(layout, passes);
    const int stops = plan_turns(land, plan), without = turns_without_room(plan) + stops;
    if (plan.pieces.empty()) return best;
    if (without < fewest) {
      fewest = without;
      best = passes;
    }
    if (without == 0) return best;
    const PassesByBoundary more = as_set(problem, sum_of(passes, lacking_passes(plan, land), most));
    if (more == passes) return best;
    passes = more;
  }
  return best;
}

}  // namespace tramline
