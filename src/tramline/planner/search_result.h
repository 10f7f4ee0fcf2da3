#pragma once
// What a search hands to the planner.

#include <functional>

#include "tramline/planner/candidate.h"

namespace tramline {

/// How far a search has come. Called from worker threads, one at a time.
using Progress = std::function<void(int done, int total)>;

struct SearchResult {
  Candidate best;
  int directions_tried = 0;
  Proof proof;
};

}  // namespace tramline
