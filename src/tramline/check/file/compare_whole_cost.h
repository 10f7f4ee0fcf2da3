#pragma once

#include <string>
#include <vector>

#include "tramline/check/verify.h"
#include "tramline/model/objective.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Checks that hours, litres and euros of the whole cost are those of the legs of the route and of the areas
/// of the tally by the rates that are stated, and that these are those of the machine, as far as it has its
/// own. They may differ by 1e-6, absolutely or relatively. What legs take, areas, and the way over tracks are
/// matters of other rules. Rule "whole cost". Preconditions: verify(plan).complete; the plan has a route.
/// O(legs).
std::vector<Violation> compare_whole_cost(const Plan& plan, const StatedCost& stated);

/// The keys of those stated rates that compare_whole_cost() cannot refute: of prices that have no effect on
/// this plan and that its machine does not have for its own.
std::vector<std::string> rates_without_effect(const Plan& plan, const StatedCost& stated);

}  // namespace tramline::check
