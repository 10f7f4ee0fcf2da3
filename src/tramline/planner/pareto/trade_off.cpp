#include "tramline/planner/pareto/trade_off.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/explain/explanation.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/pareto/dominance.h"
#include "tramline/planner/pareto/front_marks.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/search_result.h"
#include "tramline/planner/warnings.h"

namespace tramline {

/// The common input of all searches, the result of each, and the origin of each plan of the front.
struct TradeOffSearches {
  struct Search {
    Objective prices;
    SearchResult found;  ///< of all but the first without `seen`, which has gone into the front
  };
  struct Origin {
    std::size_t search = 0;
    std::vector<LinedSubfield> lined_subfields;
  };
  PlanningProblem problem;
  PreparedField prepared;        ///< whatever the prices
  std::vector<Search> searches;  ///< the first is that for the given prices
  std::vector<Origin> origins;   ///< by point of the front
};

namespace {

using Grounds = std::vector<LinedSubfield>;

SearchTask task_of(const TradeOffSearches& all, std::size_t search) {
  return {all.problem, all.prepared, all.searches[search].prices};
}

/// A plan that may belong to the front.
struct Laid {
  TradeOffSearches::Origin origin;
  Tally tally;
};

/// The plans that the search has laid out; the chosen one comes first.
std::vector<Laid> laid_by(std::size_t search, const SearchResult& found) {
  std::vector<Laid> out;
  out.push_back({{search, lined_subfields_of(found.best)}, found.best.avoided.tally});
  for (const SeenPlan& seen : found.seen) out.push_back({{search, seen.lined_subfields}, seen.tally});
  return out;
}

/// Removes dominated plans and plans without a piece.
std::vector<Laid> best_of(std::vector<Laid> laid) {
  std::erase_if(laid, [](const Laid& plan) { return plan.tally.pieces == 0; });
  std::vector<Tally> tallies;
  for (const Laid& plan : laid) tallies.push_back(plan.tally);
  std::vector<Laid> out;
  for (const std::size_t i : undominated(tallies)) out.push_back(std::move(laid[i]));
  return out;
}

/// `first`: the result of the first search, where it is known.
void run_searches(TradeOffSearches& all, std::optional<SearchResult> first, const SearchContext& context) {
  const std::vector<Objective> prices = prices_to_search(all.problem.objective);
  for (const Objective& one : prices) all.searches.push_back({one, {}});
  std::mutex mutex;
  int done = 0;
  for_each_index_until_end(prices.size(), context, [&](std::size_t i) {
    all.searches[i].found =
        i == 0 && first ? std::move(*first) : straight_search(task_of(all, i), context.uncounted());
    const std::lock_guard lock(mutex);
    context.count(++done, static_cast<int>(prices.size()));
  });
}

/// Each plan again at the prices of every other search: the same tracks may end elsewhere, and pass obstacles
/// in another way.
std::vector<Laid> laid_anew(const TradeOffSearches& all, const std::vector<Laid>& laid,
                            const SearchContext& context) {
  const std::size_t count = all.searches.size();
  std::vector<Laid> out(laid.size() * count);
  for_each_index_until_end(out.size(), context, [&](std::size_t i) {
    const TradeOffSearches::Origin& origin = laid[i / count].origin;
    const std::size_t search = i % count;
    if (search == origin.search) return;
    out[i] = {{search, origin.lined_subfields},
              candidate_on(task_of(all, search), origin.lined_subfields).avoided.tally};
  });
  return out;
}

/// Replaces tallies by those of tracks and headland passes together, and removes plans that are then
/// dominated.
std::vector<Laid> with_headland(const TradeOffSearches& all, std::vector<Laid> laid,
                                const SearchContext& context) {
  if (all.prepared.headland.passes.empty()) return laid;
  for_each_index(laid.size(), context, [&](std::size_t i) {
    const SearchTask task = task_of(all, laid[i].origin.search);
    laid[i].tally = whole_tally_of(task, candidate_on(task, laid[i].origin.lined_subfields));
  });
  return best_of(std::move(laid));
}

Front front_of(const TradeOffSearches& all, const std::vector<Laid>& laid) {
  const Objective& prices = all.problem.objective;
  Front front;
  front.prices = prices;
  for (const Laid& plan : laid) {
    FrontPoint point{plan.tally, {}, all.searches[plan.origin.search].prices, cost(prices, plan.tally)};
    for (const LinedSubfield& ground : plan.origin.lined_subfields)
      point.directions.push_back(ground.subfield.direction);
    front.points.push_back(std::move(point));
  }
  front.marks = marks_for(front);
  return front;
}

Plan marked(const TradeOff& trade_off, Plan plan) {
  if (trade_off.cut_short) mark_cut_short(plan);
  return plan;
}

}  // namespace

void require_straight_tracks(const PlanSettings& settings) {
  if (settings.tracks == TrackConstruction::kPaper)
    throw bad_input("tracks as in the paper cannot be compared; leave out --tracks paper");
  if (settings.shape != TrackShape::kStraight)
    throw bad_input(
        "only plans with straight tracks can be compared; leave out --curved, or give a line without bends");
}

std::vector<Objective> prices_to_search(const Objective& given) {
  std::vector<Objective> out;
  const auto add = [&out](const Objective& prices) {
    if (std::none_of(out.begin(), out.end(), [&](const Objective& other) { return prices == other; }))
      out.push_back(prices);
  };
  add(given);
  for (const Scenario scenario : {Scenario::kOverlap, Scenario::kUncovered, Scenario::kTurns})
    add(weights_of(scenario));
  for (const double factor : {0.125, 0.5, 2.0, 8.0}) {
    add({given.overlap * factor, given.uncovered, given.turn, given.stop, given.subfield});
    add({given.overlap, given.uncovered * factor, given.turn, given.stop, given.subfield});
    add({given.overlap, given.uncovered, given.turn * factor, given.stop * factor, given.subfield * factor});
  }
  return out;
}

TradeOff trade_off(const Field& field, const Machine& machine, const Objective& prices,
                   const PlanSettings& settings, int threads, const Progress& progress) {
  auto searches = std::make_shared<TradeOffSearches>();
  TradeOffSearches& all = *searches;
  all.problem = planning_problem(field, machine, prices, settings);
  all.problem.settings.aim = Aim::kCost;  // plans are compared by their tracks
  require_straight_tracks(settings);
  if (settings.given.divides())
    throw bad_input(
        "plans with subfields that are drawn cannot be compared; leave out --front or --subfields");
  const SearchContext context(threads, progress);
  std::optional<Preparation> prepared = prepare_field(all.problem, context);
  if (!prepared) throw no_room(all.problem);
  all.prepared = std::move(prepared->field);
  run_searches(all, std::move(prepared->found), context);
  const Candidate& first = all.searches.front().found.best;
  require_tracks(task_of(all, 0), first.avoided.tally);
  if (!first.works())
    throw bad_input(fmt::format(
        "the field '{}' is worked by its headland passes alone, so there are no plans to compare", field.id));

  std::vector<Laid> laid;
  for (std::size_t i = 0; i < all.searches.size(); ++i) {
    for (Laid& plan : laid_by(i, all.searches[i].found)) laid.push_back(std::move(plan));
    if (i > 0) all.searches[i].found.seen.clear();  // the first may have to be explained
  }
  laid = best_of(std::move(laid));
  for (Laid& plan : laid_anew(all, laid, context)) laid.push_back(std::move(plan));
  laid = with_headland(all, best_of(std::move(laid)), context);

  TradeOff out{front_of(all, laid), context.cut_short(), nullptr};
  for (Laid& plan : laid) all.origins.push_back(std::move(plan.origin));
  out.searches = std::move(searches);
  return out;
}

Plan plan_of(const TradeOff& trade_off, std::size_t point) {
  const TradeOffSearches::Origin& origin = trade_off.searches->origins[point];
  const SearchTask task = task_of(*trade_off.searches, origin.search);
  SearchResult laid = trade_off.searches->searches[origin.search].found;
  laid.best = candidate_on(task, origin.lined_subfields);
  return marked(trade_off, finished_plan(task, std::move(laid), SearchContext()));
}

Plan given_plan(const TradeOff& trade_off) {
  return marked(trade_off, finished_plan(task_of(*trade_off.searches, 0),
                                         trade_off.searches->searches.front().found, SearchContext()));
}

Explanation why_given(const TradeOff& trade_off, int threads) {
  return explanation_of(task_of(*trade_off.searches, 0), trade_off.searches->searches.front().found,
                        SearchContext(threads));
}

}  // namespace tramline
