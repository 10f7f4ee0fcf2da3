#include "tramline/planner/plans/cheapest_headlands.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/headland_choice/trial_corners.h"
#include "tramline/planner/plans/headlands_by_turns.h"

namespace tramline {
namespace {

double price(const HeadlandTrial& of) { return whole_cost(of.draft.plan).euros(); }

/// The same layout behind other passes, of which the cheapest route is kept.
class OtherPasses {
 public:
  OtherPasses(HeadlandTrial best, const PlanningProblem& problem, const Plan& layout,
              const SearchContext& context)
      : best_(std::move(best)), problem_(problem), layout_(layout), context_(context), least_(price(best_)) {
    best_.passes.obstacles.resize(problem.field.obstacles.size(), 0);
  }

  /// All round the field, from one on as long as more of them cost less.
  void try_all_round() {
    constexpr int kMost = 6;
    PassesByBoundary passes{std::vector<int>(problem_.field.outer.size(), 0), best_.passes.obstacles};
    double before = kAnyCost;
    for (int all_round = 1; all_round <= kMost && !context_.has_to_end(); ++all_round) {
      passes.edges.assign(passes.edges.size(), all_round);
      const std::optional<double> euros = tried(passes);
      if (!euros || *euros > before) return;
      before = *euros;
    }
  }

  /// Round obstacles, from one less than the most on as long as fewer cost less.
  void try_fewer_round_obstacles() {
    PassesByBoundary passes = best_.passes;
    double before = kAnyCost;
    for (int most = deepest(passes.obstacles) - 1; most >= 0 && !context_.has_to_end(); --most) {
      for (int& n : passes.obstacles) n = std::min(n, most);
      const std::optional<double> euros = tried(passes);
      if (!euros || *euros > before) return;
      before = *euros;
    }
  }

  HeadlandTrial best() && { return std::move(best_); }

 private:
  static int deepest(const std::vector<int>& passes) {
    return passes.empty() ? 0 : *std::ranges::max_element(passes);
  }

  /// What the route costs behind these passes; nullopt where they leave no track.
  std::optional<double> tried(const PassesByBoundary& passes) {
    std::optional<HeadlandTrial> trial =
        headland_trial(problem_, layout_, as_set(problem_, passes), Offset::kOfLayout, context_);
    if (!trial) return std::nullopt;
    const double euros = price(*trial);
    if (euros < least_) {
      least_ = euros;
      best_ = *std::move(trial);
    }
    return euros;
  }

  HeadlandTrial best_;
  const PlanningProblem& problem_;
  const Plan& layout_;
  const SearchContext& context_;
  double least_;
};

/// With the headlands that the turns of the layout need, or behind others where its route then costs less.
HeadlandTrial cheapest_behind(const PlanningProblem& problem, const Plan& layout,
                              const SearchContext& context, const SearchContext& deepening) {
  const SearchContext comparing = context.uncounted().without_bound();
  OtherPasses others(with_headlands_for_turns(problem, layout, deepening), problem, layout, comparing);
  if (problem.settings.headland_rule == HeadlandRule::kTurns) others.try_all_round();
  if (problem.settings.obstacle_headland_rule == HeadlandRule::kTurns) others.try_fewer_round_obstacles();
  return std::move(others).best();
}

/// Passes that are given instead of following from turns.
struct GivenPasses {
  std::optional<int> round_field{};
  std::optional<int> round_obstacles{};
};

PlanSettings with_given(PlanSettings settings, const GivenPasses& given) {
  if (given.round_field) {
    settings.headland_rule = HeadlandRule::kPasses;
    settings.headlands = *given.round_field;
  }
  if (given.round_obstacles) {
    settings.obstacle_headland_rule = HeadlandRule::kPasses;
    settings.obstacle_headlands = *given.round_obstacles;
  }
  return settings;
}

/// Behind given passes, which other tracks may suit better than those of the bare field. nullopt where no
/// track fits.
std::optional<HeadlandTrial> trial_behind(const GivenPasses& given, const PlanningProblem& problem,
                                          const SearchContext& context) {
  PlanningProblem fixed = problem;
  fixed.settings = with_given(problem.settings, given);
  PlanningProblem bare = headlands_follow_turns(fixed.settings) ? without_headlands_for_turns(fixed) : fixed;
  bare.settings.turns = TurnPlanning::kNone;
  Plan layout;
  try {
    layout = searched_plan(bare, context.for_layout(), Explain::kNo).plan;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  if (layout.subfields.empty()) return std::nullopt;
  std::optional<HeadlandTrial> out;
  if (headlands_follow_turns(fixed.settings))
    out = cheapest_behind(fixed, layout, context, context);
  else
    out = headland_trial(fixed, layout,
                         as_set(fixed, {std::vector<int>(fixed.field.outer.size(), 0),
                                        std::vector<int>(fixed.field.obstacles.size(), 0)}),
                         Offset::kOfLayout, context);
  if (!out) return std::nullopt;
  for (PlanSettings* const settings : {&out->problem.settings, &out->draft.plan.settings}) {
    settings->headland_rule = problem.settings.headland_rule;
    settings->obstacle_headland_rule = problem.settings.obstacle_headland_rule;
    settings->obstacle_headlands = problem.settings.obstacle_headlands;
  }
  return out;
}

/// The cheaper of two trials, the first where both cost the same; nothing where there is none.
std::optional<HeadlandTrial> cheaper_of(std::optional<HeadlandTrial> a, std::optional<HeadlandTrial> b) {
  if (!a || (b && price(*b) < price(*a))) return b;
  return a;
}

/// The cheapest behind so many passes round all obstacles, or as many as turns need: with those round the
/// field that turns need, and with given ones from one on as long as more of them cost less.
std::optional<HeadlandTrial> cheapest_with(std::optional<int> round_obstacles, const PlanningProblem& problem,
                                           const SearchContext& context) {
  constexpr int kMostRoundField = 6;
  std::optional<HeadlandTrial> best;
  if (round_obstacles) best = trial_behind({std::nullopt, round_obstacles}, problem, context);
  if (problem.settings.headland_rule != HeadlandRule::kTurns) return best;
  double before = kAnyCost;
  for (int number = 1; number <= kMostRoundField && !context.has_to_end(); ++number) {
    std::optional<HeadlandTrial> next = trial_behind({number, round_obstacles}, problem, context);
    if (!next) continue;
    const double euros = price(*next);
    best = cheaper_of(std::move(best), std::move(next));
    if (euros > before) break;
    before = euros;
  }
  return best;
}

/// The trial, or the cheapest behind given passes.
HeadlandTrial or_behind_given(HeadlandTrial first, const PlanningProblem& problem,
                              const SearchContext& context) {
  std::vector<std::optional<int>> round_obstacles{std::nullopt};
  if (problem.settings.obstacle_headland_rule == HeadlandRule::kTurns && !problem.field.obstacles.empty())
    round_obstacles.insert(round_obstacles.end(), {1, 2});
  std::vector<std::optional<HeadlandTrial>> found(round_obstacles.size());
  for_each_index(found.size(), context,
                 [&](std::size_t i) { found[i] = cheapest_with(round_obstacles[i], problem, context); });
  std::optional<HeadlandTrial> best(std::move(first));
  for (std::optional<HeadlandTrial>& one : found) best = cheaper_of(std::move(best), std::move(one));
  return *std::move(best);
}

}  // namespace

HeadlandTrial with_cheapest_headlands(const PlanningProblem& problem, const Plan& layout,
                                      const SearchContext& context, const SearchContext& deepening) {
  assert(headlands_follow_turns(problem.settings) && problem.settings.turns == TurnPlanning::kRoute);
  return or_with_worked_corners(or_behind_given(cheapest_behind(problem, layout, context, deepening), problem,
                                                context.uncounted().without_bound()));
}

}  // namespace tramline
