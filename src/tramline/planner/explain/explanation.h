#pragma once
// Why a plan is the one that was chosen: what its cost is made of, and what the next best would have cost.

#include <vector>

#include "tramline/cost/cost_causes.h"
#include "tramline/planner/search/search_context.h"
#include "tramline/planner/search/search_result.h"

namespace tramline {

/// What a plan costs above another one; negative where it costs less, by what is paid for.
struct CostDifference {
  double overlap = 0;
  double uncovered = 0;
  double turns = 0;
  double stops = 0;
  double subfields = 0;

  double sum() const { return overlap + uncovered + turns + stops + subfields; }
};

CostDifference difference(const Objective& objective, const Tally& of, const Tally& from);

/// overlap, uncovered, turns, stops or subfields: what is largest; among equals the first.
const char* main_reason(const CostDifference& more);

/// A plan that was not chosen.
struct RunnerUp {
  std::vector<Direction> directions;  ///< of the subfields that have tracks
  Tally tally;
  double cost = 0;
  CostDifference more;  ///< than the chosen plan
};

struct Explanation {
  CostCauses causes;                 ///< of the chosen plan, headland passes included
  std::vector<RunnerUp> runner_ups;  ///< cheapest first
  RunnerUp longest_side;             ///< the ground undivided, with tracks along the field's longest side
};

/// Of the best plan of a search. Runner-ups are up to five of the plans that the search has laid out or had
/// on its shortlists; of the latter, those that may be cheap enough are laid out here. From the best plan and
/// from one another they differ in the number of subfields, or by more than a degree in a direction.
/// Deterministic for any number of threads.
Explanation explanation_of(const SearchTask& task, const SearchResult& found, const SearchContext& context);

}  // namespace tramline
