#pragma once
// S1's search: one candidate for every distinct edge direction, the cheapest is kept.

#include <optional>

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// S1.19 for every direction, in the order of candidate_directions(), and counted for the progress. Those
/// that a search which has to end leaves out are missing.
std::vector<SweptGround> swept_grounds(const SearchTask& task, const SearchContext& context);

/// The cheapest of them with its detours; among equals that of the smallest sweep direction. Ways past
/// obstacles are looked for where the outlook leaves hope only, the best outlook first; the one that is
/// cheapest with all tracks cut is always among these. The result depends neither on that order nor on the
/// number of threads. nullopt where none that works anything costs less than `known`.
std::optional<Candidate> cheapest_swept(const SearchTask& task, const std::vector<SweptGround>& swept,
                                        double known, const SearchContext& context);

/// Both. Without a plan where all cost more than `no_more_than`.
SearchResult sweep_search(const SearchTask& task, const SearchContext& context,
                          double no_more_than = kAnyCost);

/// The least number above `most`: what costs less than that costs no more than `most`.
double just_above(double most);

}  // namespace tramline
