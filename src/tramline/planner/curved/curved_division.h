#pragma once
// Ground divided for straight tracks, some of whose subfields are better driven along a curve.

#include <cstdint>
#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// What subfields that no curve suits better have.
enum class OtherSubfields : std::uint8_t { kStraight, kCurved };

/// Subfields of a division get the best curve along one of their own edges where it is cheaper than their
/// straight tracks, or where all are to be curved. Neighbours are joined as long as one curve costs less than
/// the tracks of both: so a crooked strip is driven along its bends, and not in straight parts. Subfields are
/// priced by themselves, borders taken as plain edges; of what comes of the divisions the cheapest is kept.
/// Where all are to be curved, a subfield that no curve suits goes with the largest. nullopt where no curve
/// is chosen. Deterministic for any number of threads. O(s) searches for a curve and one for each pair of
/// neighbours, for s subfields.
std::optional<Candidate> best_division_along_curves(const SearchTask& task,
                                                    const std::vector<std::vector<LinedSubfield>>& divisions,
                                                    OtherSubfields others, const SearchContext& context);

/// The subfields of a sweep's candidate that divides the ground, the one that looks best before the ways past
/// obstacles are known; empty where none does.
std::vector<LinedSubfield> hopeful_division(const SearchTask& task, const std::vector<SweptGround>& swept);

}  // namespace tramline
