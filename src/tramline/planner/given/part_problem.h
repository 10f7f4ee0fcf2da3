#pragma once
// Parts of the land as a problem of their own.

#include "tramline/planner/candidate/search_task.h"

namespace tramline {

/// Some parts of a prepared field, without headlands, to be searched as if they were a field of their own.
class PartProblem {
 public:
  PartProblem(const PlanningProblem& whole, const PreparedField& prepared, Region shapes, MayDivide divide);

  /// Refers to this object.
  SearchTask task() const { return {problem_, prepared_}; }

 private:
  PlanningProblem problem_;
  PreparedField prepared_;
};

}  // namespace tramline
