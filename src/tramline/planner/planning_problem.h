#pragma once
// The problem that the planner solves.

#include <memory>

#include "tramline/model/plan.h"
#include "tramline/route/build/lines_beside_boundaries.h"

namespace tramline {

/// A field with the machine, prices and settings to plan it with.
struct PlanningProblem {
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
  /// What routes may follow through narrows; shared by all problems of this field and machine.
  std::shared_ptr<const LinesForNarrower> for_narrower = std::make_shared<LinesForNarrower>();
};

/// The problem of a request. Where headlands are asked for, the field's own boundary is hard, whatever the
/// settings say, and its anchor is not the default one but what that amounts to. Throws kBadInput as
/// validate_request() does, where the envelope is to be the anchor of no line or of one with bends, and where
/// the field is so large that the number of tracks would overflow.
PlanningProblem planning_problem(const Field& field, const Machine& machine, const Objective& objective,
                                 const PlanSettings& settings);

}  // namespace tramline
