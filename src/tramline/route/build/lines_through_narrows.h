#pragma once
// Lines through land that is too narrow for the machine.

#include <vector>

#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap.h"

namespace tramline {

/// The parts of lines of a narrower machine, round all boundaries, that lead where no line followed by the
/// machine does: farther from all of these than half its breadth and kBesideLines_m, and at least
/// kShortestNarrows_m long. Tracks do not count, which are left at their ends only. `ground`: of the machine,
/// not the narrower one. O((n + m)·log(n + m)) for lines of n and m metres.
std::vector<FollowedLine> lines_through_narrows(const std::vector<FollowedLine>& round_boundaries,
                                                const std::vector<FollowedLine>& followed,
                                                const DrivingGround& ground);

inline constexpr double kBesideLines_m = 1;
inline constexpr double kShortestNarrows_m = 4;

}  // namespace tramline
