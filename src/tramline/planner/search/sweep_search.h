#pragma once
// Versleijen's search: one candidate for every distinct edge direction; the cheapest is kept.

#include <optional>

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Versleijen §2.2.5 for every direction, in the order of candidate_directions(), counted for the progress. A
/// search that has to end early may leave some out.
std::vector<SweptCandidate> swept_candidates(const SearchTask& task, const SearchContext& context);

/// The cheapest of them with its detours; among equals that of the smallest sweep direction. Ways past
/// obstacles are searched for only where the outlook is good enough, best outlook first; the candidate that
/// is cheapest with all tracks cut is always among these. The result depends neither on that order nor on the
/// number of threads. nullopt where no candidate with a piece costs less than `known`.
std::optional<Candidate> cheapest_swept(const SearchTask& task, const std::vector<SweptCandidate>& swept,
                                        double known, const SearchContext& context);

/// What of the search was left out: directions beyond kMostSweepDirections, and candidates beyond those tried
/// whose outlook is better than the cost of the best plan found.
SweepLimits sweep_limits(const SearchTask& task, const std::vector<SweptCandidate>& swept, double cost);

/// swept_candidates() followed by cheapest_swept(). The result has no plan where all cost more than
/// `no_more_than`.
SearchResult sweep_search(const SearchTask& task, const SearchContext& context,
                          double no_more_than = kAnyCost);

/// The least number above `most`: a cost below it is at most `most`.
double just_above(double most);

}  // namespace tramline
