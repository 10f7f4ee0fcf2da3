#pragma once
// What the planner is asked.

#include "tramline/model/plan.h"

namespace tramline {

/// A field, and what plans for it are made for and by.
struct PlanningProblem {
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
};

/// The problem of a request. Where headlands are asked for the field's own boundary is hard, whatever the
/// settings say. Throws kBadInput as validate_request() does, and where the field is so large that tracks
/// could not be counted.
PlanningProblem planning_problem(const Field& field, const Machine& machine, const Objective& objective,
                                 const PlanSettings& settings);

}  // namespace tramline
