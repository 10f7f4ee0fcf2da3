#pragma once
// Prices on the ground that prove how cheap no plan is, whatever its division.

#include "tramline/model/plan.h"
#include "tramline/planner/candidate/search_task.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// How much is done for good prices. Whatever it is, they prove what they say.
struct PriceEffort {
  int most_cells = 500;
  int rounds = 30;         ///< of the linear program, in each of which it is told more pieces
  double samples = 1.5e8;  ///< of the ground, for a sweep of all directions and offsets; about so many
  int fewest_lines = 3;    ///< into which the width is divided all the same, however large the land
};

/// Prices of square cells such that no piece of a plan is worth more than its turn: no plan of
/// tracks costs less than the sum of prices and land, less one turn (docs/bounds.md). Cells lie along the
/// given direction. Local metres. None where obstacles are in the way: planning_problem() refuses to prove
/// anything of such fields.
GroundPrices proven_prices(const SearchTask& task, Direction along, const SearchContext& context,
                           const PriceEffort& effort = {});

}  // namespace tramline
