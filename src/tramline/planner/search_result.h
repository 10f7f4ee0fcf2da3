#pragma once
// The result that a search passes to the planner.

#include <limits>
#include <vector>

#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// No limit on the cost of plans.
inline constexpr double kAnyCost = std::numeric_limits<double>::infinity();

/// A plan that the search has laid out and tallied.
struct SeenPlan {
  std::vector<LinedSubfield> lined_subfields;  ///< input from which candidate_on() makes the plan again
  std::vector<Direction> directions;           ///< of the subfields that have tracks
  Tally tally;
  double cost = 0;
};

SeenPlan seen_plan(const Candidate& candidate);

/// One candidate of the sweep.
struct SweptCandidate {
  std::vector<LinedSubfield> lined_subfields;
  Outlook outlook;
};

/// What Versleijen's search left out.
struct SweepLimits {
  int directions = 0;           ///< of all the field's edges
  int directions_left_out = 0;  ///< since there are very many of them
  int without_detours = 0;      ///< candidates whose detours were not looked for though they might be cheaper
};

struct SearchResult {
  Candidate best;
  int directions_tried = 0;
  Proof proof;                 ///< of tracks on the body, headland passes left out
  std::vector<SeenPlan> seen;  ///< plans of the whole field, in the order in which they were tried
  /// Undivided plans of the whole field that were priced and looked good, whether in `seen` or not.
  std::vector<std::vector<LinedSubfield>> shortlist;
  std::vector<SweptCandidate> swept;  ///< every candidate of the sweep
  /// The best plan found that leaves the land undivided, where the best of all divides it.
  std::vector<LinedSubfield> undivided;
  SweepLimits limits{};  ///< of Strategy::kSweep
};

}  // namespace tramline
