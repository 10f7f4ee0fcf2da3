#pragma once
// The input that all candidates of one search share.

#include "tramline/planner/planning_problem.h"
#include "tramline/planner/prepared_field.h"
#include "tramline/route/build/patience.h"

namespace tramline {

/// A problem and the field prepared for it. Refers to its arguments, which have to outlive it.
struct SearchTask {
  SearchTask(const PlanningProblem& problem, const PreparedField& prepared)
      : SearchTask(problem, prepared, problem.objective) {}
  /// The same at prices other than those of the problem.
  SearchTask(const PlanningProblem& problem, const PreparedField& prepared, const Objective& prices)
      : field(problem.field),
        machine(problem.machine),
        objective(prices),
        settings(problem.settings),
        ground(prepared.ground),
        headland(prepared.headland),
        hard_field(prepared.hard_field),
        body_m2(prepared.body_m2),
        short_edge_m(prepared.short_edge_m),
        clearance_takes_all(prepared.clearance_takes_all),
        given(prepared.given),
        may_divide(prepared.may_divide),
        turning_land(*prepared.turning_land),
        beside_boundaries(*prepared.beside_boundaries),
        for_narrower(*problem.for_narrower) {}

  const Field& field;
  const Machine& machine;
  const Objective& objective;
  const PlanSettings& settings;
  const ClassifiedGround& ground;
  const Headland& headland;
  const Region& hard_field;
  double body_m2;
  double short_edge_m;
  bool clearance_takes_all;
  const PreparedLand& given;
  MayDivide may_divide;
  const AllowedLand& turning_land;
  const LinesBesideBoundaries& beside_boundaries;
  const LinesForNarrower& for_narrower;
  Patience patience = Patience::kUsual;
};

}  // namespace tramline
