#pragma once
// Plans of one problem whose routes are planned and priced, as far as they may be the cheapest.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/plan_field.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/whole/compared_plans.h"
#include "tramline/planner/whole/route_layouts.h"

namespace tramline {

/// All plans that are compared, or those that may be the cheapest.
enum class Compare { kWhatMayWin, kAll };

/// The plans compared so far, and the cheapest of them. Not for several threads.
class RouteComparison {
 public:
  /// `problem`: with the order of the route that was asked for. The context outlives the comparison.
  RouteComparison(const PlanningProblem& problem, Compare compare, const SearchContext& context);

  const PlanningProblem& problem() const { return problem_; }
  const SearchContext& context() const { return context_; }
  const ComparedPlans& plans() const { return plans_; }
  /// Whether there is a plan, and time to look for a cheaper one.
  bool goes_on() const { return best_ && !context_.has_to_end(); }
  bool has_to_end() const { return context_.has_to_end(); }
  /// Whether routes took so long, where ways are hard to find, that no more plans are made from the best ones
  /// by other passes, obstacles, directions and lines. Told by what they searched through, not by a clock.
  bool took_enough() const;
  bool goes_on_varying() const { return goes_on() && !took_enough(); }

  bool has_best() const { return best_.has_value(); }
  /// Precondition of these: has_best().
  const HeadlandTrial& best() const;
  const Plan& best_plan() const { return best().draft.plan; }
  /// EUR; infinite where there is none.
  double least_price() const;
  /// Less than this the route of the entry is not expected to cost, EUR: its floor, and what it costs beyond
  /// at the least, as least_beyond_floor() has it.
  double least_expected(const ComparedPlan& entry) const;

  /// Its number among plans().
  std::size_t add(LaidOut laid);
  std::size_t add(ComparedPlan entry);
  /// Plans its route and tells of it, unless the same tracks have theirs, and says whether it is the cheapest
  /// so far. Where that is not to be expected its route is planned to be told of only, so that explaining a
  /// plan does not change it.
  bool improves(std::size_t i);
  /// Adds it, if there is one, and says the same.
  bool improves(std::optional<LaidOut> laid);
  /// The same unless one like it is known, has_such_as_cheap().
  bool improves_on_such(std::optional<LaidOut> laid);
  /// Routes of all that have none, those of the lowest floors first.
  struct Share {
    double from = 0, to = 1;
  };
  void plan_routes(const Share& of_progress);

  /// Plans the route of an entry that is not one of plans().
  void plan_route(ComparedPlan& entry, Patience patience = Patience::kUsual);
  /// Looks longer for the order of a plan that has a route, and says whether it is the cheapest then.
  bool improves_in_order(std::size_t i);
  /// Takes an entry with a route, which is cheaper than all others.
  void take(ComparedPlan entry);

  /// What is told of, in the order in which it was planned.
  const std::vector<RouteAlternative>& told_of() const { return told_of_; }
  /// Precondition of the first: the entry has its route.
  void tell_of(const ComparedPlan& entry);
  void tell_of(RouteAlternative alternative) { told_of_.push_back(std::move(alternative)); }
  /// Precondition: has_best().
  HeadlandTrial& best_to_finish();

 private:
  bool is_told_of(const ComparedPlan& entry);
  /// Whether a plan with a route is the cheapest so far. It is the best one then.
  bool is_cheapest(std::size_t i);

  PlanningProblem problem_;
  Compare compare_;
  const SearchContext& context_;
  ComparedPlans plans_;
  std::optional<std::size_t> best_{};
  std::size_t reached_ = 0;  ///< by searches for ways of plans that could win
  std::vector<RouteAlternative> told_of_;
};

}  // namespace tramline
