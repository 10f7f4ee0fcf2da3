#pragma once
// Gaps that are worked together where that costs less.

#include <vector>

#include "tramline/planner/gap_grids.h"

namespace tramline {

/// Gaps with the lines chosen for them.
struct GapGroup {
  GapGround ground;
  GapChoice choice;
};

/// Joins two groups at a time, the two that save most first, as long as the grid for both costs less than the
/// two grids: lines then go on from one gap to the next, with the work off between, and one swath covers what
/// lies under it. Looked at are the eight nearest groups of each, no farther off than 30 w. Deterministic for
/// any number of threads. O(n) joint grids, and n² boxes.
std::vector<GapGroup> join_where_it_pays(std::vector<GapGroup> groups, const Region& free,
                                         const Region& obstacles, const RepairTerms& terms, int threads);

}  // namespace tramline
