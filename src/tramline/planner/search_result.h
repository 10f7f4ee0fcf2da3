#pragma once
// What a search hands to the planner.

#include <limits>
#include <vector>

#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// As the most that plans may cost: no limit.
inline constexpr double kAnyCost = std::numeric_limits<double>::infinity();

/// A plan the search has laid out and tallied on its way.
struct SeenPlan {
  std::vector<LinedSubfield> grounds;  ///< candidate_on() makes the plan of it again
  std::vector<Direction> directions;   ///< of the subfields that have tracks
  Tally tally;
  double cost = 0;
};

SeenPlan seen_plan(const Candidate& candidate);

/// One candidate of the sweep.
struct SweptGround {
  std::vector<LinedSubfield> grounds;
  Outlook outlook;
};

struct SearchResult {
  Candidate best;
  int directions_tried = 0;
  Proof proof;                 ///< of tracks on the body, headland passes left out
  std::vector<SeenPlan> seen;  ///< of the whole field, in the order in which they were looked at
  /// Plans of the whole field, undivided, that were priced and looked good; seen or not.
  std::vector<std::vector<LinedSubfield>> shortlist;
  std::vector<SweptGround> swept;  ///< every candidate of the sweep
  /// The best plan found that leaves the ground undivided, where the best of all divides it.
  std::vector<LinedSubfield> undivided;
};

}  // namespace tramline
