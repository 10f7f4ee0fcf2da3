#pragma once
// The whole trade-off: what a field's plans have to choose between, not only the cheapest at some prices.

#include <memory>
#include <vector>

#include "tramline/model/explanation.h"
#include "tramline/model/front.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"

namespace tramline {

/// The searches behind a front.
struct TradeOffSearches;

/// A front, and what it takes to lay its plans again.
struct TradeOff {
  Front front;
  bool cut_short = false;  ///< the progress wanted an end before all searches were through
  std::shared_ptr<const TradeOffSearches> searches;
};

/// Throws kBadInput where the settings ask for other than straight tracks: others are not compared.
void require_straight_tracks(const PlanSettings& settings);

/// The prices that trade_off() searches for, no two alike: those given, S1's three scenarios, and those
/// given with one of the prices of overlap, of uncovered land, and of turns and stops times 1/8, 1/2, 2 and
/// 8. At most 16.
std::vector<Objective> prices_to_search(const Objective& given);

/// The plans that none of the others dominates (see dominates()) among all that the searches for
/// prices_to_search() have laid, and those again with ends of swaths and ways past obstacles after the other
/// prices. Plans without a piece are left out. A sample: there may be plans that no search has met.
/// Errors as those of plan_field(), and kBadInput where the settings ask for other than straight tracks, or
/// passes alone work the field. `progress` counts searches. Takes as long as prices_to_search().size()
/// plans, and a little. Deterministic for any number of threads.
TradeOff trade_off(const Field& field, const Machine& machine, const Objective& prices,
                   const PlanSettings& settings, int threads = 0, const Progress& progress = {});

/// The plan of a point of the front, with the prices it was laid for as its objective.
Plan plan_of(const TradeOff& trade_off, std::size_t point);

/// The plan that plan_field() makes for the given prices.
Plan given_plan(const TradeOff& trade_off);

/// Why it is the one: what plan_and_explain() says, without another search.
Explanation why_given(const TradeOff& trade_off, int threads = 0);

}  // namespace tramline
