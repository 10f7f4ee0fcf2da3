#include "tramline/planner/whole/cheapest_route.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/whole/route_floor.h"
#include "tramline/planner/whole/route_layouts.h"
#include "tramline/planner/whole/track_prices.h"

namespace tramline {
namespace {

/// A leg without room cannot be driven as it is planned: it is avoided at the price of so many stops.
constexpr double kStopsWithoutRoom = 10;
/// Obstacles lose or get their headlands one by one where there are no more of them than this.
constexpr std::size_t kMostObstaclesAlone = 6;

double price_of(const Plan& plan) {
  const auto without_room = static_cast<double>(sums_of(plan.route).without_room);
  return whole_cost(plan).euros() + kStopsWithoutRoom * rates_of(plan.machine).price_per_stop * without_room;
}

RouteAlternative alternative_of(Alternative kind, const Plan& plan) {
  RouteAlternative out;
  out.kind = kind;
  for (const Subfield& subfield : plan.subfields) out.directions.push_back(subfield.direction);
  out.headlands = plan.settings.headlands;
  out.all_round = plan.settings.headland_edges.empty();
  out.cost = whole_cost(plan);
  out.without_room = sums_of(plan.route).without_room;
  return out;
}

/// A plan to be compared. It has its route where it has a price.
struct Entry {
  LaidOut laid;
  double floor = 0;
  std::optional<double> price{};
};

class Comparison {
 public:
  Comparison(const PlanningProblem& problem, const Plan& layout, Compare compare,
             const SearchContext& context)
      : problem_(problem), compare_(compare), context_(context), layouts_(problem, layout, context) {
    problem_.settings.turns = TurnPlanning::kNone;
  }

  ComparedRoutes cheapest(const RoomForTurns& room_for_turns) {
    for (LaidOut& laid : layouts_.to_begin_with()) add(std::move(laid));
    plan_routes();
    if (best_) vary_depth();
    if (best_) vary_obstacles();
    if (compare_ == Compare::kAll) add_for_comparison();
    std::optional<Plan> deepened;
    if (!best_ || !drives_everywhere()) deepened = with_room(room_for_turns);
    return compared(std::move(deepened));
  }

 private:
  void add(LaidOut laid) {
    const double floor = route_floor(laid.trial.draft.plan, *laid.trial.prepared.turning_land);
    entries_.push_back({std::move(laid), floor});
  }

  double least_price() const {
    return best_ ? *entries_[*best_].price : std::numeric_limits<double>::infinity();
  }

  void plan_route(Entry& entry) {
    context_.report();
    HeadlandTrial& trial = entry.laid.trial;
    trial.problem.settings.turns = TurnPlanning::kRoute;
    trial.draft = drafted(SearchTask(trial.problem, trial.prepared), trial.found);
    entry.price = price_of(trial.draft.plan);
    all_.push_back(alternative_of(entry.laid.kind, trial.draft.plan));
  }

  /// Whether the entry is the cheapest so far; its route is not planned where it cannot be.
  bool improves(std::size_t i) {
    Entry& entry = entries_[i];
    if (context_.cut_short() && best_) return false;
    if (entry.floor >= least_price() && compare_ == Compare::kWhatMayWin) return false;
    const double before = least_price();
    plan_route(entry);
    if (*entry.price >= before) return false;
    best_ = i;
    return true;
  }

  bool improves(std::optional<LaidOut> laid) {
    if (!laid) return false;
    add(std::move(*laid));
    return improves(entries_.size() - 1);
  }

  void plan_routes() {
    std::vector<std::size_t> order(entries_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return entries_[a].floor < entries_[b].floor; });
    for (const std::size_t i : order) improves(i);
  }

  const HeadlandTrial& best() const { return entries_[*best_].laid.trial; }

  /// One pass more or less all round the field, as long as that costs less.
  void vary_depth() {
    if (problem_.settings.headland_rule != HeadlandRule::kTurns) return;
    for (const int step : {1, -1})
      for (int passes = layouts_.least_passes() + step; passes > 0; passes += step) {
        bool cheaper = false;
        for (LaidOut& laid : layouts_.behind(passes, best().passes.obstacles, best().draft.plan))
          cheaper = improves(std::move(laid)) || cheaper;
        if (!cheaper) break;
      }
  }

  /// Obstacles with headlands lose them, and those without get them.
  void vary_obstacles() {
    if (problem_.settings.obstacle_headland_rule != HeadlandRule::kTurns) return;
    const std::vector<int>& needed = layouts_.obstacle_passes();
    const auto count = static_cast<std::size_t>(
        std::count_if(needed.begin(), needed.end(), [](int passes) { return passes > 0; }));
    if (count > kMostObstaclesAlone) return;
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (needed[i] == 0) continue;
      std::vector<int> passes = best().passes.obstacles;
      passes[i] = passes[i] > 0 ? 0 : needed[i];
      try_obstacles(passes);
    }
  }

  bool is_known(const Plan& like, const PassesByBoundary& passes) const {
    return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.laid.trial.passes == passes && same_directions(entry.laid.trial.draft.plan, like);
    });
  }

  void try_obstacles(const std::vector<int>& passes) {
    PassesByBoundary with = best().passes;
    with.obstacles = passes;
    if (is_known(best().draft.plan, with)) return;
    improves(layouts_.laid_out(Alternative::kSearched, best().draft.plan, with));
  }

  /// What is told besides, however much it costs: no headland, and the best plan in adjacent order.
  void add_for_comparison() {
    if (!best_) return;
    if (problem_.settings.headland_rule == HeadlandRule::kTurns) {
      PassesByBoundary none = best().passes;
      std::fill(none.edges.begin(), none.edges.end(), 0);
      improves(layouts_.laid_out(Alternative::kNoHeadland, best().draft.plan, none));
    }
    if (problem_.settings.route.order != TrackOrder::kBest) return;
    LaidOut adjacent{Alternative::kAdjacent, best()};
    adjacent.trial.problem.settings.route.order = TrackOrder::kBySpacing;
    Entry entry{std::move(adjacent)};
    plan_route(entry);
  }

  bool drives_everywhere() const {
    const Plan& plan = best().draft.plan;
    return sums_of(plan.route).without_room == 0 && plan.tally.stops == 0;
  }

  /// The plan with headlands deepened where turns lack room, if that costs less. Where there is no other plan
  /// its error is thrown.
  std::optional<Plan> with_room(const RoomForTurns& room_for_turns) {
    if (context_.cut_short() && best_) return std::nullopt;
    try {
      Plan plan = room_for_turns();
      if (!plan.route.planned()) return plan;
      all_.push_back(alternative_of(Alternative::kRoomForTurns, plan));
      if (price_of(plan) < least_price()) return plan;
    } catch (const Error& error) {
      if (!best_ || error.kind() != ErrorKind::kBadInput) throw;
    }
    return std::nullopt;
  }

  ComparedRoutes compared(std::optional<Plan> deepened) {
    ComparedRoutes out;
    const double stop = rates_of(problem_.machine).price_per_stop;
    const auto price = [stop](const RouteAlternative& one) {
      return one.cost.euros() + kStopsWithoutRoom * stop * static_cast<double>(one.without_room);
    };
    std::stable_sort(
        all_.begin(), all_.end(),
        [&](const RouteAlternative& a, const RouteAlternative& b) { return price(a) < price(b); });
    out.all = std::move(all_);
    if (deepened) {
      out.plan = std::move(*deepened);
      return out;
    }
    HeadlandTrial& trial = entries_[*best_].laid.trial;
    out.plan = finished(SearchTask(trial.problem, trial.prepared), std::move(trial.found),
                        std::move(trial.draft), context_);
    return out;
  }

  PlanningProblem problem_;
  Compare compare_;
  const SearchContext& context_;
  RouteLayouts layouts_;
  std::vector<Entry> entries_;
  std::optional<std::size_t> best_{};
  std::vector<RouteAlternative> all_;
};

}  // namespace

const char* name(Alternative alternative) {
  switch (alternative) {
    case Alternative::kSearched:
      return "as searched";
    case Alternative::kLongestSide:
      return "along the longest side";
    case Alternative::kLength:
      return "along the length";
    case Alternative::kUndivided:
      return "undivided";
    case Alternative::kNoHeadland:
      return "no headland";
    case Alternative::kAdjacent:
      return "adjacent order";
    case Alternative::kRoomForTurns:
      return "room for turns";
  }
  return "";
}

bool compares_routes(const PlanSettings& settings) {
  return settings.aim == Aim::kWholeCost && settings.turns == TurnPlanning::kRoute &&
         settings.shape != TrackShape::kCurved && settings.guide.empty() && !settings.given.divides() &&
         settings.tracks == TrackConstruction::kParallel && settings.strategy == Strategy::kBest;
}

PlanningProblem with_track_prices(PlanningProblem problem) {
  problem.objective = track_prices(problem.machine);
  return problem;
}

ComparedRoutes cheapest_route(const PlanningProblem& problem, const Plan& layout,
                              const RoomForTurns& room_for_turns, Compare compare,
                              const SearchContext& context) {
  assert(compares_routes(problem.settings));
  ComparedRoutes out = Comparison(problem, layout, compare, context).cheapest(room_for_turns);
  // What a search proves of the cost of tracks says nothing about whole routes.
  out.plan.proof = {};
  out.plan.proof.cut_short = context.cut_short();
  return out;
}

}  // namespace tramline
