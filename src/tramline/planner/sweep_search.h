#pragma once
// S1's search: one candidate for every distinct edge direction, the cheapest is kept.

#include <functional>

#include "tramline/planner/candidate.h"

namespace tramline {

/// How far a search has come. Called from worker threads, one at a time.
using Progress = std::function<void(int done, int total)>;

struct SweepResult {
  Candidate best;
  int directions_tried = 0;
};

/// S1.19. Candidates are evaluated in parallel by `threads` threads (0: all cores); the result does
/// not depend on their number: the cheapest wins, among equals the smallest sweep direction.
SweepResult sweep_search(const SearchTask& task, int threads, const Progress& progress);

}  // namespace tramline
