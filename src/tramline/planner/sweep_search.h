#pragma once
// S1's search: one candidate for every distinct edge direction, the cheapest is kept.

#include <optional>

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// S1.19 for every direction, in the order of candidate_directions(); those left out
/// where the search has to end are missing. Counts them.
std::vector<SweptGround> swept_grounds(const SearchTask& task, const SearchContext& context);

/// The cheapest of them with its detours; among equals that of the smallest sweep direction. Ways past
/// obstacles are looked for where the outlook leaves hope only, the best outlook first. The result depends
/// neither on that nor on the number of threads. nullopt where none that works anything costs less than
/// `known`.
std::optional<Candidate> cheapest_swept(const SearchTask& task, const std::vector<SweptGround>& swept,
                                        double known, const SearchContext& context);

/// Both; without a plan where none costs `no_more_than` or less.
SearchResult sweep_search(const SearchTask& task, const SearchContext& context,
                          double no_more_than = kAnyCost);

/// The least number above: what costs less costs no more than `most`.
double just_above(double most);

}  // namespace tramline
