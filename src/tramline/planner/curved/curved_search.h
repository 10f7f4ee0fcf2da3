#pragma once
// Tracks along edges of the field, in all its subfields or in some.

#include <optional>

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The cheapest tracks along one curve in each part of the ground (best_curved), or S2's own along the best
/// line. nullopt where no edge is a curve that tracks could follow.
std::optional<Candidate> along_best_edge(const SearchTask& task, const SearchContext& context);

/// The cheapest curved tracks: these, or with a curve for each subfield where the ground is divided as
/// straight tracks would have it (best_division_along_curves); S2's leave it whole. nullopt where no edge is
/// a curve that tracks could follow.
std::optional<Candidate> curved_search(const SearchTask& task, const SearchContext& context);

/// The cheapest tracks that are curved in some subfields at least: the ground divided as in the best straight
/// plan that was found, or as in the sweep's most hopeful one. nullopt where none has a curve that pays.
std::optional<Candidate> mixed_search(const SearchTask& task, const SearchResult& straight,
                                      const SearchContext& context);

/// Does ground divided for curves cost less by more than rounding than what there is without?
bool costs_less(double divided, double whole);

}  // namespace tramline
