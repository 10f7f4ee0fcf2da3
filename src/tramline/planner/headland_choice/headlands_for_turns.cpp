#include "tramline/planner/headland_choice/headlands_for_turns.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tramline/planner/for_each_index.h"
#include "tramline/planner/headland_choice/foreseen_passes.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/needed_passes.h"
#include "tramline/planner/prepare_field.h"

namespace tramline {
namespace {

/// So many times passes are added where turns lack room between tracks laid anew: their offset has changed.
constexpr int kMostDeepenings = 2;
/// Passes beyond those that the deepest turn of the layout needs: round corners turns reach deeper.
constexpr int kMorePasses = 2;

/// A trial with its turns, and the passes that these still lack.
struct Tried {
  HeadlandTrial trial;
  PassesByBoundary lacking;

  const Plan& plan() const { return trial.draft.plan; }
};

/// Whether more than one turn in so many is without room: then the tracks may lie the wrong way.
constexpr int kSeldomWithoutRoom = 10;

bool often_without_room(const Plan& plan) {
  return kSeldomWithoutRoom * turns_without_room(plan) > static_cast<int>(plan.turns.size());
}

/// Over a turn without room the machine backs out of one track and into the next.
double whole_price(const Plan& plan) {
  return plan.cost + 2 * plan.objective.stop * turns_without_room(plan);
}

bool is_better(const Plan& a, const Plan& b) {
  const int of_a = turns_without_room(a) + a.tally.stops, of_b = turns_without_room(b) + b.tally.stops;
  return of_a != of_b ? of_a < of_b : a.cost < b.cost;
}

class HeadlandsForTurns {
 public:
  HeadlandsForTurns(const PlanningProblem& problem, const Plan& layout, const SearchContext& context)
      : problem_(problem), asked_(problem.settings.turns), layout_(layout), context_(context) {
    problem_.settings.turns = TurnPlanning::kTurns;
  }

  /// The cheapest plan found with its headlands, nothing where none leaves room for a track.
  std::optional<Tried> cheapest() {
    const PassesByBoundary first = needed();
    most_passes_ = deepest(first) + kMorePasses;
    std::optional<Tried> best =
        cheapest_of(ways_round(foreseen_passes(problem_, layout_, first, most_passes_, context_)));
    // A field too small for all of them gets as many as leave room for tracks.
    for (int most = deepest(first) - 1; !best && most >= 0; --most)
      best = improved(no_more_than(first, most));
    return best;
  }

  /// The passes that the turns of the layout need.
  PassesByBoundary needed() const { return as_set(problem_, needed_passes(layout_)); }

  /// With obstacles without headland and at the offset that suit it best, and the turns that were asked for.
  HeadlandTrial settled(Tried best) {
    if (problem_.settings.obstacle_headland_rule == HeadlandRule::kTurns) leave_out_obstacles(best);
    move_to_best_offset(best);
    return drafted_with(std::move(best.trial), asked_);
  }

 private:
  /// Passes where turns need them, and these with a pass along the bare edges too: that costs less where much
  /// land would be left beside tracks that end inside.
  std::vector<PassesByBoundary> ways_round(PassesByBoundary passes) const {
    std::vector<PassesByBoundary> out{std::move(passes)};
    if (problem_.settings.headland_rule != HeadlandRule::kTurns) return out;
    PassesByBoundary all_round = out.front();
    for (int& n : all_round.edges) n = std::max(n, 1);
    if (all_round != out.front()) out.push_back(std::move(all_round));
    return out;
  }

  /// Each improved(); the cheapest of them, the first among equals.
  std::optional<Tried> cheapest_of(const std::vector<PassesByBoundary>& ways) const {
    std::vector<std::optional<Tried>> tried(ways.size());
    for_each_index(ways.size(), context_, [&](std::size_t i) { tried[i] = improved(ways[i]); });
    std::optional<Tried> best;
    for (std::optional<Tried>& one : tried)
      if (one && (!best || whole_price(one->plan()) < whole_price(best->plan()))) best = std::move(one);
    return best;
  }

  static PassesByBoundary no_more_than(PassesByBoundary passes, int most) {
    for (int& n : passes.edges) n = std::min(n, most);
    for (int& n : passes.obstacles) n = std::min(n, most);
    return passes;
  }

  /// The passes and those that are lacking, as the settings allow.
  PassesByBoundary with_lacking(const Tried& tried) const {
    return as_set(problem_, sum_of(tried.trial.passes, tried.lacking, most_passes_));
  }

  /// The best plan of a few rounds, each with the passes added that the one before lacked.
  std::optional<Tried> improved(PassesByBoundary passes) const {
    std::optional<Tried> best;
    for (int round = 0; round < kMostDeepenings; ++round) {
      context_.report();
      std::optional<Tried> tried = tried_with(passes);
      if (!tried) return best;
      const bool lacks = deepest(tried->lacking) > 0;
      const PassesByBoundary more = with_lacking(*tried);
      if (!best || is_better(tried->plan(), best->plan())) best = std::move(tried);
      if (!lacks || more == passes) return best;
      passes = more;
    }
    return best;
  }

  static Tried with_lacking_of(HeadlandTrial trial) {
    PassesByBoundary lacking = lacking_passes(trial.draft.plan, *trial.prepared.turning_land);
    return {std::move(trial), std::move(lacking)};
  }

  /// nullopt where no track is left.
  std::optional<Tried> tried_with(const PassesByBoundary& passes, Offset offset = Offset::kOfLayout) const {
    std::optional<HeadlandTrial> trial = headland_trial(problem_, layout_, passes, offset, context_);
    if (!trial) return std::nullopt;
    return with_lacking_of(std::move(*trial));
  }

  /// The offset of the layout is the best one where passes along the sides are as wide as tracks. Elsewhere
  /// another one may cost less. The ends of tracks, and with them the turns, move a little: passes that they
  /// lack then are added once.
  void move_to_best_offset(Tried& tried) const {
    std::optional<HeadlandTrial> trial = headland_trial_on(tried.trial.problem, tried.trial.prepared, layout_,
                                                           tried.trial.passes, Offset::kBest, context_);
    if (!trial) return;
    std::optional<Tried> moved = with_lacking_of(std::move(*trial)), again;
    const PassesByBoundary more = with_lacking(*moved);
    if (deepest(moved->lacking) > 0 && more != moved->trial.passes) again = tried_with(more, Offset::kBest);
    for (std::optional<Tried>* other : {&moved, &again})
      if (*other && is_better((*other)->plan(), tried.plan())) tried = std::move(**other);
  }

  /// Obstacles lose their headland one by one where that costs less, the first ones first.
  void leave_out_obstacles(Tried& best) {
    for (std::size_t i = 0; i < best.trial.passes.obstacles.size(); ++i) {
      if (best.trial.passes.obstacles[i] == 0) continue;
      PassesByBoundary fewer = best.trial.passes;
      fewer.obstacles[i] = 0;
      std::optional<Tried> without = tried_with(fewer);
      if (without && whole_price(without->plan()) < whole_price(best.plan())) best = std::move(*without);
    }
  }

  PlanningProblem problem_;
  TurnPlanning asked_;  ///< of the plan; headlands are found with the turns between tracks
  const Plan& layout_;
  SearchContext context_;
  int most_passes_ = 0;
};

}  // namespace

HeadlandTrial trial_with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                                             const OtherLayout& behind_passes, const SearchContext& context) {
  HeadlandsForTurns search(problem, layout, context);
  std::optional<Tried> best = search.cheapest();
  if (!best || often_without_room(best->plan())) {
    const std::optional<Plan> other = behind_passes(std::max(1, deepest(search.needed())));
    if (other) {
      HeadlandsForTurns again(problem, *other, context);
      std::optional<Tried> along = again.cheapest();
      if (along && (!best || whole_price(along->plan()) < whole_price(best->plan())))
        return again.settled(std::move(*along));
    }
  }
  if (!best) throw no_room(problem);
  return search.settled(std::move(*best));
}

}  // namespace tramline
