#pragma once
// The lines of a repair: over every group of gaps, and over what they leave.

#include <functional>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/planner/enterable_gaps.h"

namespace tramline {

/// Pieces of ground done, and known so far.
using RepairProgress = std::function<void(int done, int total)>;

/// Ground with the lines that were laid for it, and what of it was left for others.
struct RepairedGround {
  Region region;
  Direction direction;
  GapLines lines;        ///< none where others cover the ground
  int gap = 0;           ///< the number of the largest gap in it
  Region left_for_more;  ///< regions of others that came of it
};

struct RepairLines {
  std::vector<RepairedGround> grounds;
  Region swaths;                     ///< of all lines, oriented
  std::vector<LeftGap> unreachable;  ///< parts of gaps taken on
};

/// Lays the lines of each group, the largest first, with better ones where others have covered part of it,
/// and then further lines over what is left, until that is smaller than the least area or no swath enters.
/// `gaps`: those the groups are of, at least one.
RepairLines repair_lines(std::vector<GapGroup> groups, const std::vector<Gap>& gaps,
                         const RepairGround& ground, const RepairProgress& progress);

}  // namespace tramline
