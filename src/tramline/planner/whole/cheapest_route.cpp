#include "tramline/planner/whole/cheapest_route.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/whole/compared_plans.h"
#include "tramline/planner/whole/dropped_tracks.h"
#include "tramline/planner/whole/plan_faults.h"
#include "tramline/planner/whole/route_alternative.h"
#include "tramline/planner/whole/route_layouts.h"
#include "tramline/planner/whole/track_prices.h"

namespace tramline {
namespace {

/// The share of what routes cost beyond their floors that the next one is expected to cost too.
constexpr double kExpected = 0.4;

/// So many passes more are tried one by one, and what lies between larger steps by halving them so often.
constexpr int kOneByOne = 6, kHalvings = 2;

/// Where a plan hardly works so many passes more than the least are tried, whether or not fewer cost more.
constexpr int kDeeper = 2;

/// So many of the grids beside one are drafted, those of least cost of their tracks, and so many get routes.
constexpr std::size_t kDrafted = 12, kRouted = 2;

/// Tracks are left out of so many plans at the most, and so many runs of them are tried alone.
constexpr std::size_t kDropsOf = 6, kTriedAlone = 3;
/// Tracks that are ordered to that end, in all such routes: as many as six of 250 have, or thirty of 50.
constexpr std::size_t kRoutedForDrops = 1500;

/// What is done of a comparison after each of its steps, about as over real fields: its first layouts, their
/// routes, headlands of other depths, and other obstacles with headlands.
constexpr double kBegun = 0.2;
constexpr double kFirstRoutes = 0.5;
constexpr double kDepthFound = 0.75;
constexpr double kObstaclesFound = 0.85;

class Comparison {
 public:
  Comparison(const PlanningProblem& problem, const std::vector<Plan>& layouts, Compare compare,
             const SearchContext& context)
      : problem_(problem),
        compare_(compare),
        context_(context),
        layouts_(problem, layouts, context.uncounted()) {
    problem_.settings.turns = TurnPlanning::kNone;
  }

  ComparedRoutes cheapest(const RoomForTurns& room_for_turns) {
    for (LaidOut& laid : layouts_.to_begin_with()) add(std::move(laid));
    context_.reach(kBegun);
    plan_routes();
    narrow_ = best_ && passes_work_most(best().prepared);
    if (!best_ || (goes_on() && open_passes_may_pay())) {
      for (LaidOut& laid : layouts_.behind_open_passes()) add(std::move(laid));
      plan_routes();
    }
    if (!best_ || goes_on()) vary_depth();
    if (goes_on()) vary_directions();
    if (goes_on()) vary_prices(PassesByBoundary(best().passes));  // a copy: plans are added
    context_.reach(kDepthFound);
    if (goes_on()) vary_obstacles();
    if (goes_on()) vary_grids();
    if (goes_on() && backs_out(best_plan())) improves(in_adjacent_order());
    if (goes_on()) drop_tracks();
    context_.reach(kObstaclesFound);
    if (goes_on() && compare_ == Compare::kAll) add_for_comparison();
    std::optional<Plan> deepened;
    if (!best_ || goes_on()) deepened = with_room(room_for_turns);
    return compared(std::move(deepened));
  }

 private:
  void add(LaidOut laid) { plans_.push_back(compared_plan(std::move(laid))); }

  bool goes_on() const { return best_ && !context_.has_to_end(); }

  double least_price() const {
    return best_ ? *plans_[*best_].price : std::numeric_limits<double>::infinity();
  }

  void plan_route(ComparedPlan& entry) {
    context_.report();
    HeadlandTrial& trial = entry.laid.trial;
    trial.problem.settings.turns = TurnPlanning::kRoute;
    trial.draft = drafted(SearchTask(trial.problem, trial.prepared), trial.found);
    // What order was taken is the planner's choice, as it was asked for.
    trial.problem.settings.route.order = trial.draft.plan.settings.route.order =
        problem_.settings.route.order;
    all_.push_back(alternative_of(entry.laid.kind, trial.draft.plan));
    entry.price = all_.back().cost.euros();
  }

  /// What the routes of this field cost beyond their floors at the least, so far; of that a part may be
  /// saved by another one.
  double least_expected(const ComparedPlan& entry) const {
    return entry.floor + kExpected * least_beyond_floor_;
  }

  /// Whether the entry is the cheapest so far. Where that is not to be expected its route is planned to be
  /// told of only, so that explaining a plan does not change it.
  bool improves(std::size_t i) {
    ComparedPlan& entry = plans_[i];
    if (entry.price || (best_ && context_.has_to_end())) return false;
    if (is_told_of(entry)) return false;
    const bool may_win = !best_ || least_expected(entry) + entry.lacks_room_like_others < least_price();
    if (!may_win && compare_ == Compare::kWhatMayWin) return false;
    const double before = least_price();
    plan_route(entry);
    entry.only_told_of = !may_win;
    if (!may_win) return false;
    // Other layouts may have room where this one has none.
    const double with_room = *entry.price - whole_cost(entry.plan()).without_room;
    least_beyond_floor_ = std::min(least_beyond_floor_, std::max(0.0, with_room - entry.floor));
    if (*entry.price >= before) return false;
    best_ = i;
    return true;
  }

  /// Whether the same tracks have their route already. In another order they are another plan.
  bool is_told_of(const ComparedPlan& entry) {
    if (entry.laid.kind == Alternative::kAdjacent) return false;
    const auto same = same_tracks_priced(plans_, entry);
    if (!same || plans_[*same].only_told_of) return false;
    if (plans_[*same].laid.kind != entry.laid.kind)
      all_.push_back(alternative_of(entry.laid.kind, plans_[*same].plan()));
    return true;
  }

  bool improves(std::optional<LaidOut> laid) {
    if (!laid) return false;
    add(std::move(*laid));
    return improves(plans_.size() - 1);
  }

  void plan_routes() {
    std::vector<std::size_t> order(plans_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return plans_[a].floor < plans_[b].floor; });
    for (std::size_t done = 0; done < order.size(); ++done) {
      ComparedPlan& entry = plans_[order[done]];
      entry.lacks_room_like_others = room_lacked_by_others(plans_, entry);
      improves(order[done]);
      const double share = static_cast<double>(done + 1) / static_cast<double>(order.size());
      context_.reach(kBegun + (kFirstRoutes - kBegun) * share);
    }
  }

  const HeadlandTrial& best() const { return plans_[*best_].laid.trial; }
  const Plan& best_plan() const { return best().draft.plan; }

  /// More or fewer passes all round the field, as long as that costs less; where the best plan hardly works
  /// all depths to some beyond the least, and no headland. The tracks of least cost behind them are searched
  /// for where the best ones so far, laid anew, come near.
  void vary_depth() {
    if (problem_.settings.headland_rule != HeadlandRule::kTurns) return;
    if (!best_ || hardly_works(best_plan())) {
      const std::vector<int> obstacles = best_ ? best().passes.obstacles : layouts_.passes_round_all();
      for (int passes = 0; passes <= layouts_.least_passes() + kDeeper; ++passes) {
        if (best_ && context_.has_to_end()) return;
        const PassesByBoundary round = layouts_.all_round(passes, obstacles);
        improves_with(round);
        if (narrow_) vary_prices(round);
        if (passes > 0) continue;
        for (LaidOut& laid : layouts_.along_sides(round)) improves(std::move(laid));
      }
      return;
    }
    if (narrow_ && !all_round(best().passes)) return;
    const int alone = layouts_.passes_alone();
    if (alone > 0 && improves_with_passes(alone)) {
      vary_depth(alone, -1);
      return;
    }
    for (const int direction : {1, -1}) vary_depth(layouts_.least_passes(), direction);
  }

  /// By one pass at a time, and after some by twice as many each time: large land may be best worked by
  /// dozens of them. Then what lies between, roughly.
  void vary_depth(int passes, int direction) {
    int step = direction;
    for (int steps = 1; improves_with_passes(passes + step); ++steps) {
      passes += step;
      if (steps >= kOneByOne) step *= 2;
    }
    for (int i = 0; i < kHalvings; ++i) {
      step /= 2;
      if (step != 0 && improves_with_passes(passes + step)) passes += step;
    }
  }

  bool improves_with_passes(int passes) {
    return passes > 0 && !context_.has_to_end() &&
           improves_with(layouts_.all_round(passes, best().passes.obstacles));
  }

  bool improves_with(const PassesByBoundary& passes) {
    if (!layouts_.leave_other_land(passes)) return false;
    bool cheaper = false, best_comes_near = true;
    for (const std::size_t like : near_the_best(plans_, least_price())) {
      std::optional<LaidOut> laid = layouts_.laid_out(Alternative::kSearched, plans_[like].plan(), passes);
      if (!laid) continue;
      add(std::move(*laid));
      const std::size_t last = plans_.size() - 1;
      best_comes_near = least_expected(plans_[last]) <= (1 + kComesNear) * least_price();
      cheaper = improves(last) || cheaper;
    }
    if (!cheaper && !best_comes_near && !(narrow_ && hardly_works(best_plan()))) return false;
    for (LaidOut& laid : layouts_.searched(passes))
      if (!has_such(plans_, laid.trial.draft.plan, passes)) cheaper = improves(std::move(laid)) || cheaper;
    return cheaper;
  }

  /// Directions that come near it behind other passes are laid behind those of the best plan.
  void vary_directions() {
    const PassesByBoundary passes = best().passes;
    for (const std::size_t like : near_the_best(plans_, least_price())) {
      const Plan& plan = plans_[like].plan();
      if (!has_such(plans_, plan, passes)) improves(layouts_.laid_out(Alternative::kSearched, plan, passes));
    }
  }

  /// The search for tracks prices a turn like the quickest one; what turns come to, only routes show. So what
  /// is best by the usual prices is laid out too.
  void vary_prices(const PassesByBoundary& passes) {
    const std::optional<Plan> usual = layouts_.best_by_usual_prices(passes);
    if (usual && !has_such(plans_, *usual, passes))
      improves(layouts_.laid_out(Alternative::kSearched, *usual, passes));
  }

  /// The tracks of the best plans moved and turned a little: where there are few, turns and ways decide, of
  /// which the cost of tracks knows nothing.
  void vary_grids() {
    for (const std::size_t i : about_as_good(plans_, least_price())) vary_grid(i);
  }

  void vary_grid(std::size_t of) {
    const Plan& plan = plans_[of].plan();
    if (plan.pieces.empty() || !has_few_tracks(plan) || !problem_.field.obstacles.empty()) return;
    ComparedPlans near;
    for (LaidOut& laid : beside(plans_[of].laid, kDrafted)) near.push_back(compared_plan(std::move(laid)));
    std::stable_sort(near.begin(), near.end(),
                     [](const ComparedPlan& a, const ComparedPlan& b) { return a.floor < b.floor; });
    for (std::size_t i = 0; i < std::min(near.size(), kRouted); ++i) {
      ComparedPlan& entry = near[i];
      if (context_.has_to_end() || least_expected(entry) >= least_price()) return;
      plans_.push_back(std::move(entry));
      improves(plans_.size() - 1);
    }
  }

  /// Obstacles with headlands lose them, and those without get them.
  void vary_obstacles() {
    if (problem_.settings.obstacle_headland_rule != HeadlandRule::kTurns) return;
    const std::vector<int> needed = layouts_.passes_round_all();
    const auto count = static_cast<std::size_t>(
        std::count_if(needed.begin(), needed.end(), [](int passes) { return passes > 0; }));
    if (count > kFewObstacles) return;
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (needed[i] == 0) continue;
      std::vector<int> passes = best().passes.obstacles;
      passes[i] = passes[i] > 0 ? 0 : needed[i];
      try_obstacles(passes);
    }
  }

  void try_obstacles(const std::vector<int>& passes) {
    PassesByBoundary with = best().passes;
    with.obstacles = passes;
    if (has_such(plans_, best().draft.plan, with)) return;
    improves(layouts_.laid_out(Alternative::kSearched, best().draft.plan, with));
  }

  /// Tracks are left out of the plans that may then cost less than the best one.
  void drop_tracks() {
    std::vector<Hopeful> hopeful = hopeful_without_tracks(plans_, least_price());
    if (hopeful.size() > kDropsOf) hopeful.resize(kDropsOf);
    for (const Hopeful& one : hopeful)
      if (!context_.has_to_end() && one.expected < least_price()) drop_tracks_of(one.plan);
  }

  void drop_tracks_of(std::size_t i) {
    ComparedPlan entry = plans_[i];
    while (drops_some(entry)) continue;
    if (*entry.price >= least_price()) return;
    plans_.push_back(std::move(entry));
    best_ = plans_.size() - 1;
  }

  /// Drops all runs of tracks at once that are not worth their ways; where that does not save what is worth
  /// it the better half of them, and so on; or else one of the next best.
  bool drops_some(ComparedPlan& entry) {
    const std::vector<PieceRun> runs = not_worth_their_ways(entry.laid.trial);
    for (std::size_t count = runs.size(); count > 0; count /= 2)
      if (drops({runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(count)}, entry)) return true;
    for (std::size_t next = 1; next < std::min(runs.size(), kTriedAlone); ++next)
      if (drops({runs[next]}, entry)) return true;
    return false;
  }

  bool drops(const std::vector<PieceRun>& runs, ComparedPlan& entry) {
    routed_for_drops_ += entry.plan().pieces.size();
    if (routed_for_drops_ > kRoutedForDrops || context_.has_to_end()) return false;
    ComparedPlan less = entry;
    less.laid.trial = without(runs, std::move(less.laid.trial));
    plan_route(less);
    if (!is_worth_dropping(entry.plan(), less.plan())) return false;
    entry = std::move(less);
    return true;
  }

  /// What is told besides, however much it costs: no headland, and the best plan in adjacent order.
  void add_for_comparison() {
    if (problem_.settings.headland_rule == HeadlandRule::kTurns) {
      PassesByBoundary none = best().passes;
      std::fill(none.edges.begin(), none.edges.end(), 0);
      if (auto bare = layouts_.laid_out(Alternative::kNoHeadland, best().draft.plan, none)) {
        ComparedPlan entry{std::move(*bare)};
        plan_route(entry);
      }
    }
    if (problem_.settings.route.order != TrackOrder::kBest) return;
    const bool known = std::any_of(all_.begin(), all_.end(), [](const RouteAlternative& one) {
      return one.kind == Alternative::kAdjacent;
    });
    if (known) return;
    ComparedPlan entry{in_adjacent_order()};
    plan_route(entry);
  }

  /// The best plan with each track beside the one before. The quickest order may back out of ends that this
  /// one leaves forward, which takes a little longer and costs less.
  LaidOut in_adjacent_order() const {
    LaidOut out{Alternative::kAdjacent, best()};
    out.trial.problem.settings.route.order = TrackOrder::kBySpacing;
    return out;
  }

  /// Passes all round take land from tracks, also beside them. Where they leave tracks most of the field that
  /// costs less than the ends of open passes, in and out of which the machine has to be turned or backed.
  bool open_passes_may_pay() const {
    return narrow_ || lacks_room(best().draft) || hardly_works(best_plan());
  }

  /// Plans of other kinds that cost less where the best one lacks room or hardly works, or where there is
  /// none. Where there is none of these either the error of the last is thrown.
  std::optional<Plan> with_room(const RoomForTurns& room_for_turns) {
    std::vector<LayoutBy> kinds;
    const bool lacks = !best_ || lacks_room(best().draft);
    if (lacks) kinds.push_back(LayoutBy::kTurns);
    if (lacks && (!best_ || has_few_tracks(best_plan()))) kinds.push_back(LayoutBy::kUsualPrices);
    if (!best_ || hardly_works_any_track(best_plan())) kinds.push_back(LayoutBy::kNoHeadland);
    std::optional<Plan> out;
    for (std::size_t i = 0; i < kinds.size() && !(out && context_.has_to_end()); ++i) {
      const double least = out ? whole_cost(*out).euros() : least_price();
      try {
        if (std::optional<Plan> other = cheaper_with_room(room_for_turns, kinds[i], least))
          out = std::move(other);
      } catch (const Error& error) {
        const bool last = i + 1 == kinds.size();
        if ((!best_ && !out && last) || error.kind() != ErrorKind::kBadInput) throw;
      }
    }
    return out;
  }

  std::optional<Plan> cheaper_with_room(const RoomForTurns& room_for_turns, LayoutBy by, double least) {
    Plan plan = room_for_turns(by);
    if (!plan.route.planned()) return plan;
    all_.push_back(alternative_of(Alternative::kRoomForTurns, plan));
    if (all_.back().cost.euros() < least) return plan;
    return std::nullopt;
  }

  ComparedRoutes compared(std::optional<Plan> deepened) {
    ComparedRoutes out;
    std::stable_sort(all_.begin(), all_.end(), [](const RouteAlternative& a, const RouteAlternative& b) {
      return a.cost.euros() < b.cost.euros();
    });
    out.all = std::move(all_);
    if (deepened) {
      out.plan = std::move(*deepened);
    } else {
      HeadlandTrial& trial = plans_[*best_].laid.trial;
      out.plan = finished(SearchTask(trial.problem, trial.prepared), std::move(trial.found),
                          std::move(trial.draft), context_);
    }
    put_first(out.plan, out.all);
    return out;
  }

  /// What is planned comes first, also where what is only told of costs less.
  static void put_first(const Plan& plan, std::vector<RouteAlternative>& all) {
    if (!plan.route.planned()) return;
    const double euros = whole_cost(plan).euros();
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const RouteAlternative& one) { return one.cost.euros() == euros; });
    if (at != all.end()) std::rotate(all.begin(), at, at + 1);
  }

  PlanningProblem problem_;
  Compare compare_;
  const SearchContext& context_;
  RouteLayouts layouts_;
  ComparedPlans plans_;
  std::optional<std::size_t> best_{};
  bool narrow_ = false;  ///< passes all round work most of the field
  std::size_t routed_for_drops_ = 0;
  double least_beyond_floor_ = std::numeric_limits<double>::max();
  std::vector<RouteAlternative> all_;
};

}  // namespace

bool compares_routes(const PlanSettings& settings) {
  return settings.aim == Aim::kWholeCost && settings.turns == TurnPlanning::kRoute &&
         settings.shape != TrackShape::kCurved && settings.guide.empty() && !settings.given.divides() &&
         settings.tracks == TrackConstruction::kParallel && settings.strategy == Strategy::kBest;
}

PlanningProblem with_track_prices(PlanningProblem problem) {
  problem.objective = track_prices(problem.machine);
  return problem;
}

ComparedRoutes cheapest_route(const PlanningProblem& problem, const std::vector<Plan>& layouts,
                              const RoomForTurns& room_for_turns, Compare compare,
                              const SearchContext& context) {
  assert(compares_routes(problem.settings) && !layouts.empty());
  ComparedRoutes out = Comparison(problem, layouts, compare, context).cheapest(room_for_turns);
  // What a search proves of the cost of tracks says nothing about whole routes.
  out.plan.proof = {};
  out.plan.proof.cut_short = context.cut_short();
  return out;
}

}  // namespace tramline
