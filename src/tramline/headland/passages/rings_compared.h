#pragma once
// Which of two sets of rings along the same boundaries is better.

#include <vector>

#include "tramline/headland/worth/worth_driving.h"
#include "tramline/model/headland.h"

namespace tramline {

/// By how much more ground rings leave, times kMissedToDoubled, and work elsewhere or again than others, m².
/// `before`: passes that have worked already. Only what lies near the
/// segments in which they differ is looked at: all else is the same for both. O(n log n) for n segments of
/// rings and corners of the ground, and the areas near those segments (newly_covered_area()).
double more_missed_and_doubled_m2(const std::vector<HeadlandPass>& rings,
                                  const std::vector<HeadlandPass>& than, const GroundToWork& to_work,
                                  const std::vector<HeadlandPass>& before);

/// Whether they meet less often than others, or as often and leave and double less by more than rounding.
bool are_better(const std::vector<HeadlandPass>& rings, const std::vector<HeadlandPass>& than,
                const GroundToWork& to_work, const std::vector<HeadlandPass>& before);

}  // namespace tramline
