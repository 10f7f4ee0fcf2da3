#pragma once
// A problem prepared for its searches, in one value.

#include "tramline/planner/candidate/search_task.h"
#include "tramline/planner/prepare_field.h"

namespace tramline::testing {

/// Without headlands.
struct Prepared {
  PlanningProblem problem;
  PreparedField field = field_without_headlands(problem);

  /// Refers to this.
  SearchTask task() const { return {problem, field}; }
};

}  // namespace tramline::testing
