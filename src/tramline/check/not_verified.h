#pragma once
// What a plan says that nothing in it can prove or refute.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::check {

/// The figures of a plan file that its verdict does not answer for, by key of the table `metadata` or by
/// layer and column ("encounters.cost_left"), as they apply to this plan: what a search proved or tried, the
/// cost of what it did not do, settings and prices that leave no trace in the tracks, what admission said of
/// the input. Names that identify things (ids, sources) are no figures. O(p) for p pieces.
std::vector<std::string> not_verified(const Plan& plan);

/// The same where the field it was made for has been compared, repairs and warnings too.
std::vector<std::string> without_field(std::vector<std::string> names);

}  // namespace tramline::check
