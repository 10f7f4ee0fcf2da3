#pragma once
// The figures of a plan with its headland: what searches compare are tracks on the body alone.

#include "tramline/planner/search_result.h"

namespace tramline {

/// The tally of a candidate's tracks and the headland's passes together.
Tally whole_tally_of(const SearchTask& task, const Candidate& candidate);

/// What a candidate costs with the headland of its task.
double whole_cost(const SearchTask& task, const Candidate& candidate);

/// Tallies and cost of a plan whose pieces are settled, from the tally of its tracks.
void set_figures(Plan& plan, const Tally& tracks);

/// What headland passes add at least to the cost of any set of tracks on the body; may be negative.
/// With o and u of the passes alone, they add λo·o + λu·u, less λo + λu for every m² that the tracks work of
/// what the passes leave, or the passes of what the tracks leave: at most all that passes leave of the
/// headland, and what they work of the body.
double least_by_headland(const SearchTask& task);

/// The proof of a search, which speaks of tracks alone, for plans with the headland. `plan` has its cost.
Proof whole_proof(const SearchTask& task, const SearchResult& found, const Plan& plan);

}  // namespace tramline
