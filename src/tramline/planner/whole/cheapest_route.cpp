#include "tramline/planner/whole/cheapest_route.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/explain/longest_side.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/headland_choice/headland_trial.h"

namespace tramline {
namespace {

/// Directions nearer to one another are one.
constexpr double kSameDirection_deg = 1;

/// A leg without room cannot be driven as it is planned: it is avoided at the price of so many stops.
constexpr double kStopsWithoutRoom = 10;

double price_of(const Plan& plan) {
  const auto without_room = static_cast<double>(sums_of(plan.route).without_room);
  return whole_cost(plan).euros() + kStopsWithoutRoom * plan.objective.stop * without_room;
}

RouteAlternative alternative_of(const Plan& plan) {
  RouteAlternative out;
  for (const Subfield& subfield : plan.subfields) out.directions.push_back(subfield.direction);
  out.headlands = plan.settings.headlands;
  out.all_round = plan.settings.headland_edges.empty();
  out.cost = whole_cost(plan);
  out.without_room = sums_of(plan.route).without_room;
  return out;
}

/// A layout of tracks in one direction; where they lie is found with the headlands.
Plan layout_along(const PlanningProblem& problem, Direction direction) {
  Plan out;
  out.machine = problem.machine;
  out.subfields.push_back({{problem.field.outer, {}}, direction});
  return out;
}

bool all_in(const Plan& plan, Direction direction) {
  return std::all_of(plan.subfields.begin(), plan.subfields.end(), [&](const Subfield& subfield) {
    return subfield.reference.empty() &&
           angle_between(subfield.direction, direction).degrees() < kSameDirection_deg;
  });
}

/// The subfields and directions of the plan, without where its tracks lie: they belong to its headlands.
Plan layout_of(const Plan& plan) {
  Plan out;
  out.machine = plan.machine;
  out.subfields = plan.subfields;
  return out;
}

class Comparison {
 public:
  Comparison(const PlanningProblem& problem, Plan found, const SearchContext& context)
      : problem_(problem), context_(context), layouts_{layout_of(found)}, obstacles_(passes_round(found)) {
    for (const Direction direction :
         {longest_side(problem.field, problem.machine.width_m), across_least_width(problem.field.outer)})
      if (std::none_of(layouts_.begin(), layouts_.end(),
                       [&](const Plan& layout) { return all_in(layout, direction); }))
        layouts_.push_back(layout_along(problem, direction));
    keep(std::move(found), 0);
  }

  ComparedRoutes cheapest() && {
    if (problem_.settings.headland_rule == HeadlandRule::kTurns)
      compare_depths();
    else
      compare_directions(PassesByBoundary{edge_passes_asked(), obstacles_});
    return std::move(out_);
  }

 private:
  std::vector<int> passes_round(const Plan& found) const {
    std::vector<int> out = found.headland.obstacle_passes;
    out.resize(problem_.field.obstacles.size(), 0);
    return out;
  }

  std::vector<int> edge_passes_asked() const {
    const PlanSettings& settings = problem_.settings;
    if (!settings.headland_edges.empty()) return settings.headland_edges;
    return std::vector<int>(problem_.field.outer.size(), settings.headlands);
  }

  PassesByBoundary all_round(int passes) const {
    return {std::vector<int>(problem_.field.outer.size(), passes), obstacles_};
  }

  /// As many passes as are as wide as half a circle and half the machine are deep.
  int least_passes() const {
    const double depth_m = problem_.machine.radius_m + 0.5 * problem_.machine.width_m;
    return std::max(1, static_cast<int>(std::ceil(depth_m / problem_.machine.width_m - kAlmostWhole)));
  }

  void compare_depths() {
    const int least = least_passes();
    compare_directions(all_round(least));
    // One more or less in the best direction, on as long as that costs less.
    for (const int step : {1, -1})
      for (int passes = least + step; passes > 0; passes += step)
        if (!improves(all_round(passes))) break;
  }

  void compare_directions(const PassesByBoundary& passes) {
    // With the passes that were asked for the plan that was found is the first of them.
    const std::size_t first = problem_.settings.headland_rule == HeadlandRule::kTurns ? 0 : 1;
    std::vector<std::optional<Plan>> plans(layouts_.size());
    for_each_index(layouts_.size(), context_, [&](std::size_t i) {
      if (i >= first) plans[i] = plan_on(layouts_[i], passes);
    });
    for (std::size_t i = first; i < plans.size(); ++i)
      if (plans[i]) keep(std::move(*plans[i]), i);
  }

  bool improves(const PassesByBoundary& passes) {
    context_.report();
    std::optional<Plan> plan = plan_on(layouts_[best_layout_], passes);
    return plan && keep(std::move(*plan), best_layout_);
  }

  /// nullopt where no track fits.
  std::optional<Plan> plan_on(const Plan& layout, const PassesByBoundary& passes) const {
    if (context_.cut_short()) return std::nullopt;
    try {
      std::optional<HeadlandTrial> trial =
          headland_trial(problem_, layout, passes, Offset::kBest, context_.uncounted());
      if (!trial) return std::nullopt;
      return finished(std::move(*trial), TurnPlanning::kRoute, context_.uncounted());
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      return std::nullopt;
    }
  }

  /// Whether it is the cheapest so far.
  bool keep(Plan plan, std::size_t layout) {
    if (!plan.route.planned()) return false;
    out_.all.push_back(alternative_of(plan));
    const double price = price_of(plan);
    if (out_.all.size() > 1 && price >= least_price_) return false;
    least_price_ = price;
    best_layout_ = layout;
    out_.plan = std::move(plan);
    return true;
  }

  static constexpr double kAlmostWhole = 1e-9;

  const PlanningProblem& problem_;
  const SearchContext& context_;
  std::vector<Plan> layouts_;
  std::vector<int> obstacles_;
  std::size_t best_layout_ = 0;
  double least_price_ = 0;
  ComparedRoutes out_;
};

}  // namespace

bool compares_routes(const PlanSettings& settings) {
  return settings.aim == Aim::kWholeCost && settings.turns == TurnPlanning::kRoute &&
         settings.shape != TrackShape::kCurved && settings.guide.empty() && !settings.given.divides() &&
         settings.tracks == TrackConstruction::kParallel && settings.strategy == Strategy::kBest;
}

ComparedRoutes cheapest_route(const PlanningProblem& problem, Plan found, const SearchContext& context) {
  assert(compares_routes(problem.settings) && found.route.planned());
  ComparedRoutes out = Comparison(problem, std::move(found), context).cheapest();
  // What a search proves of the cost of tracks says nothing about whole routes.
  out.plan.proof = {};
  out.plan.proof.cut_short = context.cut_short();
  return out;
}

}  // namespace tramline
