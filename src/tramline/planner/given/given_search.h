#pragma once
// The search where the user has divided the land.

#include "tramline/planner/planning_problem.h"
#include "tramline/planner/prepared_field.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Each part that the user drew is a subfield: along its line or in its direction, with the offset that costs
/// least, or else along the line of the settings, or in the direction found best for it alone (by Versleijen
/// §2.2.1 with Strategy::kSweep). Free land is divided and searched as if it was a field of its own. Curved
/// tracks are tried as PlanSettings::shape says. Parts are searched by themselves, with borders counted as
/// plain edges; the result is tallied together. It proves nothing about other plans. Throws kBadInput where a
/// given line cannot be followed. Deterministic for any number of threads. Precondition: the prepared field
/// has parts.
SearchResult given_search(const PlanningProblem& problem, const PreparedField& prepared,
                          const SearchContext& context);

}  // namespace tramline
