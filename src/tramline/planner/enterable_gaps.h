#pragma once
// Which gaps a repair takes on.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/planner/join_gaps.h"
#include "tramline/planner/repair_ground.h"

namespace tramline {

/// Gaps, sorted out.
struct GapsTakenOn {
  std::vector<Gap> taken;
  std::vector<GapGroup> groups;      ///< one for each of them, with lines of its own
  std::vector<LeftGap> ignored;      ///< smaller than the least area
  std::vector<LeftGap> unreachable;  ///< no swath enters
};

/// Each list in the order of the gaps. Deterministic for any number of threads. O(n) choices of lines.
GapsTakenOn enterable_gaps(const std::vector<Gap>& gaps, const RepairGround& ground, int threads);

}  // namespace tramline
