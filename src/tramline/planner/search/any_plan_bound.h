#pragma once
// A lower bound for plans with any division of the land.

#include "tramline/planner/candidate/search_task.h"

namespace tramline {

/// A lower bound of the cost of every plan, whatever its subfields, directions, offsets and detours, but for
/// what its further subfields cost: every square metre of the body costs what it costs to leave it, or its
/// share of the turn of the piece that works it, which is the smaller the longer the longest piece through
/// that place may be (docs/bounds.md). O(d · (n + K) + d · cells) for d directions, n corners and K
/// incidences of edges and strips.
double least_cost_of_any_plan(const SearchTask& task);

}  // namespace tramline
