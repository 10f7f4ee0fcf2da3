#include "tramline/planner/headland_choice/headlands_for_turns.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/planner/assembly/driven_tracks.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/headland_choice/needed_passes.h"
#include "tramline/planner/headland_choice/relaid.h"
#include "tramline/planner/headland_choice/shortened_tracks.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/route/turning/turning_land.h"

namespace tramline {
namespace {

/// So many times passes are added where turns are foreseen to lack room. Each time the ends of tracks move.
constexpr int kMostForeseen = 8;
/// So many times they are added where turns lack room between tracks laid anew: their offset has changed.
constexpr int kMostRounds = 2;
/// Passes beyond those that the deepest turn of the layout needs: round corners turns reach deeper.
constexpr int kMorePasses = 2;

struct Tried {
  PassesByBoundary passes;
  PlanningProblem problem;
  PreparedField prepared;
  SearchResult found;
  Plan plan;  ///< field, machine, objective, settings, pieces, turns, stops and cost; no layers
  PassesByBoundary lacking;
};

bool any(const PassesByBoundary& passes) {
  const auto some = [](const std::vector<int>& all) {
    return std::any_of(all.begin(), all.end(), [](int n) { return n > 0; });
  };
  return some(passes.edges) || some(passes.obstacles);
}

int deepest(const PassesByBoundary& passes) {
  int out = 0;
  for (const int n : passes.edges) out = std::max(out, n);
  for (const int n : passes.obstacles) out = std::max(out, n);
  return out;
}

int turns_without_room(const Plan& plan) {
  return static_cast<int>(std::count_if(plan.turns.begin(), plan.turns.end(), [](const PlannedTurn& turn) {
    return turn.state == TurnState::kNoRoom;
  }));
}

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
    std::optional<Tried> best = cheapest_of(ways_round(foreseen(first)));
    // A field too small for all of them gets as many as leave room for tracks.
    for (int most = deepest(first) - 1; !best && most >= 0; --most)
      best = improved(no_more_than(first, most));
    return best;
  }

  /// The passes that the turns of the layout need.
  PassesByBoundary needed() const { return as_set(needed_passes(layout_)); }

  Plan finished(Tried best) {
    if (problem_.settings.obstacle_headland_rule == HeadlandRule::kTurns) leave_out_obstacles(best);
    move_to_best_offset(best);
    return as_asked(std::move(best));
  }

  std::optional<Plan> with(const PassesByBoundary& passes) {
    std::optional<Tried> tried = tried_with(passes, Offset::kBest);
    if (!tried) return std::nullopt;
    return as_asked(std::move(*tried));
  }

 private:
  Plan as_asked(Tried tried) {
    tried.problem.settings.turns = asked_;
    return finished_plan(SearchTask(tried.problem, tried.prepared), std::move(tried.found), context_);
  }

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
      if (one && (!best || whole_price(one->plan) < whole_price(best->plan))) best = std::move(one);
    return best;
  }

  /// The passes with which most turns find room between the tracks of the layout, cut back as the passes
  /// leave them. Of equals the fewest passes.
  PassesByBoundary foreseen(PassesByBoundary passes) const {
    if (!any(passes)) return passes;
    const AllowedLand land(turning_land(problem_.field, problem_.machine, problem_with(passes).settings));
    Plan plan = layout_;
    PassesByBoundary best = passes;
    int fewest = std::numeric_limits<int>::max();
    for (int round = 0; round < kMostForeseen; ++round) {
      context_.report();
      plan.pieces = shortened_tracks(layout_, passes);
      const int stops = plan_turns(land, plan), without = turns_without_room(plan) + stops;
      if (plan.pieces.empty()) return best;
      if (without < fewest) {
        fewest = without;
        best = passes;
      }
      if (without == 0) return best;
      const PassesByBoundary more = as_set(sum(passes, lacking_passes(plan, land)));
      if (more == passes) return best;
      passes = more;
    }
    return best;
  }

  PlanningProblem problem_with(const PassesByBoundary& passes) const {
    PlanSettings settings = problem_.settings;
    settings.headland_edges = passes.edges;
    return planning_problem(problem_.field, problem_.machine, problem_.objective, settings);
  }

  /// What the settings decide instead of the turns.
  PassesByBoundary as_set(PassesByBoundary passes) const {
    const PlanSettings& settings = problem_.settings;
    if (settings.headland_rule == HeadlandRule::kPasses)
      std::fill(passes.edges.begin(), passes.edges.end(), settings.headlands);
    if (settings.obstacle_headland_rule == HeadlandRule::kPasses)
      for (std::size_t i = 0; i < passes.obstacles.size(); ++i)
        passes.obstacles[i] =
            problem_.field.obstacles[i].kind == ObstacleKind::kObstacle ? settings.obstacle_headlands : 0;
    return passes;
  }

  static PassesByBoundary no_more_than(PassesByBoundary passes, int most) {
    for (int& n : passes.edges) n = std::min(n, most);
    for (int& n : passes.obstacles) n = std::min(n, most);
    return passes;
  }

  /// The best plan of a few rounds, each with the passes added that the one before lacked.
  std::optional<Tried> improved(PassesByBoundary passes) const {
    std::optional<Tried> best;
    for (int round = 0; round < kMostRounds; ++round) {
      context_.report();
      std::optional<Tried> tried = tried_with(passes);
      if (!tried) return best;
      const PassesByBoundary lacking = tried->lacking;
      if (!best || is_better(tried->plan, best->plan)) best = std::move(tried);
      const PassesByBoundary more = as_set(sum(passes, lacking));
      if (!any(lacking) || more == passes) return best;
      passes = more;
    }
    return best;
  }

  PassesByBoundary sum(PassesByBoundary a, const PassesByBoundary& b) const {
    const auto add = [this](std::vector<int>& to, const std::vector<int>& more) {
      for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = std::max(to[i], std::min(to[i] + more[i], most_passes_));
    };
    add(a.edges, b.edges);
    add(a.obstacles, b.obstacles);
    return a;
  }

  /// nullopt where no track is left.
  std::optional<Tried> tried_with(const PassesByBoundary& passes, Offset offset = Offset::kOfLayout) const {
    const PlanningProblem problem = problem_with(passes);
    const std::optional<PreparedField> prepared = field_behind(problem, passes.obstacles);
    if (!prepared || area(prepared->ground.plannable) == 0) return std::nullopt;
    return laid_on(passes, problem, *prepared, offset);
  }

  std::optional<Tried> laid_on(const PassesByBoundary& passes, const PlanningProblem& problem,
                               const PreparedField& prepared, Offset offset) const {
    SearchResult found = relaid(problem, prepared, layout_, offset, context_.uncounted());
    if (!found.best.works()) return std::nullopt;
    found.directions_tried = layout_.directions_tried;
    Plan plan = sketched(SearchTask(problem, prepared), found.best);
    PassesByBoundary lacking = lacking_passes(plan, *prepared.turning_land);
    return Tried{passes, problem, prepared, std::move(found), std::move(plan), std::move(lacking)};
  }

  /// The offset of the layout is the best one where passes along the sides are as wide as tracks. Elsewhere
  /// another one may cost less. The ends of tracks, and with them the turns, move a little: passes that they
  /// lack then are added once.
  void move_to_best_offset(Tried& tried) const {
    std::optional<Tried> moved = laid_on(tried.passes, tried.problem, tried.prepared, Offset::kBest);
    if (!moved) return;
    const PassesByBoundary more = as_set(sum(moved->passes, moved->lacking));
    std::optional<Tried> again;
    if (any(moved->lacking) && more != moved->passes) again = tried_with(more, Offset::kBest);
    for (std::optional<Tried>* other : {&moved, &again})
      if (*other && is_better((*other)->plan, tried.plan)) tried = std::move(**other);
  }

  static Plan sketched(const SearchTask& task, const Candidate& candidate) {
    Plan out;
    out.field = task.field;
    out.machine = task.machine;
    out.objective = task.objective;
    out.settings = task.settings;
    out.pieces = driven_tracks(task, candidate).pieces;
    out.tally = whole_tally_of(task, candidate);
    out.tally.stops = plan_turns(task.turning_land, out);
    out.cost = cost(task.objective, out.tally);
    return out;
  }

  /// Obstacles lose their headland one by one where that costs less, the first ones first.
  void leave_out_obstacles(Tried& best) {
    for (std::size_t i = 0; i < best.passes.obstacles.size(); ++i) {
      if (best.passes.obstacles[i] == 0) continue;
      PassesByBoundary fewer = best.passes;
      fewer.obstacles[i] = 0;
      std::optional<Tried> without = tried_with(fewer);
      if (without && whole_price(without->plan) < whole_price(best.plan)) best = std::move(*without);
    }
  }

  PlanningProblem problem_;
  TurnPlanning asked_;  ///< of the plan; headlands are found with the turns between tracks
  const Plan& layout_;
  SearchContext context_;
  int most_passes_ = 0;
};

}  // namespace

Plan plan_with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                                   const OtherLayout& behind_passes, const SearchContext& context) {
  HeadlandsForTurns search(problem, layout, context);
  std::optional<Tried> best = search.cheapest();
  if (!best || often_without_room(best->plan)) {
    const std::optional<Plan> other = behind_passes(std::max(1, deepest(search.needed())));
    if (other) {
      HeadlandsForTurns again(problem, *other, context);
      std::optional<Tried> along = again.cheapest();
      if (along && (!best || whole_price(along->plan) < whole_price(best->plan)))
        return again.finished(std::move(*along));
    }
  }
  if (!best) throw no_room(problem);
  return search.finished(std::move(*best));
}

std::optional<Plan> plan_with_passes(const PlanningProblem& problem, const Plan& layout,
                                     const PassesByBoundary& passes, const SearchContext& context) {
  return HeadlandsForTurns(problem, layout, context).with(passes);
}

}  // namespace tramline
