#pragma once
// Prices on the ground that prove how cheap no plan is, whatever its division.

#include "tramline/model/plan.h"
#include "tramline/planner/candidate/search_task.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// Prices of at most 500 square cells such that no piece of a plan is worth more than its turn: no plan of
/// tracks costs less than the sum of prices and land, less one turn (docs/bounds.md). Cells lie along the
/// given direction. Local metres.
GroundPrices proven_prices(const SearchTask& task, Direction along, const SearchContext& context);

}  // namespace tramline
