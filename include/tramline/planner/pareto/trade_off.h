#pragma once
// The trade-off of a field: its Pareto front of plans instead of the cheapest plan at given prices.

#include <memory>
#include <vector>

#include "tramline/model/explanation.h"
#include "tramline/model/front.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"

namespace tramline {

/// The searches behind a front.
struct TradeOffSearches;

/// A front, with what is needed to lay out its plans again.
struct TradeOff {
  Front front;
  bool cut_short = false;  ///< the progress callback ended the searches early
  std::shared_ptr<const TradeOffSearches> searches;
};

/// Throws kBadInput unless the settings ask for straight tracks: only these are compared.
void require_straight_tracks(const PlanSettings& settings);

/// The sets of prices that trade_off() searches for, no two alike: the given prices, Versleijen's three
/// scenarios, and the given prices with the price of overlap, that of uncovered land, or those of turns and
/// stops multiplied by 1/8, 1/2, 2 and 8. At most 16.
std::vector<Objective> prices_to_search(const Objective& given);

/// The undominated plans (see dominates()) among all that the searches for prices_to_search() have laid out,
/// each also with ends of swaths and ways past obstacles chosen at the other prices. Plans without a piece
/// are left out. The front is a sample: there may be better plans that no search has found. Errors: those of
/// plan_field(), and kBadInput where the settings ask for other than straight tracks, or where headland
/// passes alone work the field. `progress` counts searches. Takes a little longer than
/// prices_to_search().size() plans. Deterministic for any number of threads.
TradeOff trade_off(const Field& field, const Machine& machine, const Objective& prices,
                   const PlanSettings& settings, int threads = 0, const Progress& progress = {});

/// The plan of a point of the front, with the prices it was laid out for as its objective.
Plan plan_of(const TradeOff& trade_off, std::size_t point);

/// The plan that plan_field() makes for the given prices.
Plan given_plan(const TradeOff& trade_off);

/// The explanation of given_plan(): that of plan_and_explain(), without another search.
Explanation why_given(const TradeOff& trade_off, int threads = 0);

}  // namespace tramline
