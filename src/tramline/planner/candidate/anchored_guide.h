#pragma once
// The line that tracks along a guide are numbered from.

#include <vector>

#include "tramline/planner/candidate/search_task.h"

namespace tramline {

/// The guide, or the side of the body's envelope that takes its place (PlanSettings::ab_anchor).
/// Precondition: where the anchor is the envelope, the guide has two points and there is land to plan.
std::vector<Point> anchored_guide(const SearchTask& task);

}  // namespace tramline
