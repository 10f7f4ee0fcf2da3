#pragma once
// The figures of a plan including its headland. Searches compare the tracks on the body alone.

#include "tramline/planner/search_result.h"

namespace tramline {

/// The tally of a candidate's tracks and the headland's passes together.
Tally whole_tally_of(const SearchTask& task, const Candidate& candidate);

/// The cost of a candidate together with the headland of its task.
double cost_with_headland(const SearchTask& task, const Candidate& candidate);

/// Tallies and cost of a plan whose pieces are settled, from the tally of its tracks.
void set_figures(Plan& plan, const Tally& tracks);

/// The least that headland passes add to the cost of any set of tracks on the body; may be negative.
/// With overlap o and uncovered land u of the passes alone, they add λo·o + λu·u, less λo + λu for every m²
/// that the tracks work of land the passes leave, or the passes of land the tracks leave. That area is at
/// most all land that the passes leave of the headland plus all land that they work of the body.
double least_by_headland(const SearchTask& task);

/// The proof of a search, which covers tracks alone, extended to plans with the headland. `plan` has its
/// cost.
Proof whole_proof(const SearchTask& task, const SearchResult& found, const Plan& plan);

}  // namespace tramline
