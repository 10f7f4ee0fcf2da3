#pragma once
// Tracks along the line that the user gave.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/candidate/search_task.h"

namespace tramline {

/// Tracks along the guide of the settings with its bends, on all of the ground. Precondition: there is a
/// guide. Throws kBadInput where no track can follow it. O(laying the tracks).
Candidate along_guide(const SearchTask& task);

}  // namespace tramline
