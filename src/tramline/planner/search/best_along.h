#pragma once
// The best offset of tracks whose direction is settled.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The subfield with tracks in its direction, at the best offset: the cheapest of all where there are no
/// obstacles, else the best of a few with detours. `task` is of the subfield alone.
LinedSubfield best_along(const SearchTask& task, Subfield subfield, const SearchContext& context);

}  // namespace tramline
