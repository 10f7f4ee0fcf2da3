#pragma once
// Divisions made for straight tracks, some of whose subfields are better driven along a curve.

#include <cstdint>
#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The tracks of subfields for which no curve is cheaper.
enum class OtherSubfields : std::uint8_t { kStraight, kCurved };

/// Each subfield of a division gets the best curve along one of its own edges where that is cheaper than its
/// straight tracks, or where all are to be curved. Neighbours are joined as long as one curve costs less than
/// the tracks of both, so that a crooked strip is driven along its bends and not in straight parts. Subfields
/// are priced by themselves, with borders counted as plain edges; the cheapest result of all divisions is
/// kept. Where all are to be curved, a subfield that no curve suits is joined to the largest. nullopt where
/// no curve is chosen. Deterministic for any number of threads. O(s) searches for a curve and one for each
/// pair of neighbours, for s subfields.
std::optional<Candidate> best_division_along_curves(const SearchTask& task,
                                                    const std::vector<std::vector<LinedSubfield>>& divisions,
                                                    OtherSubfields others, const SearchContext& context);

/// The subfields of the sweep's candidate that looks best, before ways past obstacles are known, among those
/// that divide the land; empty where none does.
std::vector<LinedSubfield> hopeful_division(const SearchTask& task, const std::vector<SweptCandidate>& swept);

}  // namespace tramline
