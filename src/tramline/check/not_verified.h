#pragma once
// The statements of a plan that nothing in it can prove or refute.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::check {

/// The figures of a plan file that its verdict does not cover, by key of the table `metadata` or by layer and
/// column ("encounters.cost_left"), as they apply to this plan: what a search proved or tried, the cost of
/// ways not chosen, settings and prices that leave no trace in the tracks, and reports of admission on the
/// input. Names that identify things (ids, sources) are not figures. O(p) for p pieces.
std::vector<std::string> not_verified(const Plan& plan);

/// The names that remain once the field has been compared with its input, including repairs and warnings.
std::vector<std::string> without_field(std::vector<std::string> names);

/// Without the rates of the machine, where they have been compared with a whole cost (compare_whole_cost()).
std::vector<std::string> without_rates(std::vector<std::string> names);

}  // namespace tramline::check
