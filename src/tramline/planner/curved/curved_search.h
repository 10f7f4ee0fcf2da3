#pragma once
// The search for tracks along curved edges of the field, in all its subfields or in some.

#include <optional>

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The cheapest tracks along one curve in each part of the land (best_curved), or with Zhou's construction
/// along the best line. nullopt where no edge is a curve that tracks could follow, or where all are soon
/// certain to cost more than `no_more_than` (best_curved).
std::optional<Candidate> along_best_edge(const SearchTask& task, const SearchContext& context,
                                         double no_more_than = kAnyCost);

/// The cheapest curved tracks: those of along_best_edge(), or tracks along a curve in each subfield of a
/// division made for straight tracks (best_division_along_curves). Zhou's construction leaves the land
/// undivided. nullopt where no edge is a curve that tracks could follow.
std::optional<Candidate> curved_search(const SearchTask& task, const SearchContext& context);

/// The cheapest tracks that are curved in at least some subfields, with the land divided as in the best
/// straight plan found or as in the sweep's most hopeful candidate. nullopt where no subfield has a curve
/// that pays.
std::optional<Candidate> mixed_search(const SearchTask& task, const SearchResult& straight,
                                      const SearchContext& context);

/// Whether land divided for curves costs less than without the division, by more than rounding.
bool costs_less(double divided, double whole);

}  // namespace tramline
