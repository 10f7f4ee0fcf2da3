#pragma once
// Whole plans in a direction that is given, with which the plan of least whole cost is compared.

#include <optional>
#include <string>

#include "tramline/model/plan.h"
#include "tramline/planner/planning_problem.h"

namespace tramline::testing {

/// The settings of the program where nothing is asked for; with Aim::kCost: where a cost of tracks decides.
PlanSettings settings_for(Aim aim);

/// The euros by which plans are compared.
double price_of(const Plan& plan);

/// From end to end of the longest track; nothing where there is none.
std::optional<Direction> main_direction(const Plan& plan);

/// Length to width of the smallest rectangle round the field.
double elongation(const Field& field);

/// The cheapest plan with all tracks in this direction: behind one to five passes all round, with headlands
/// of obstacles as in `like`, as many all round, and none; and along a line in this direction that lies flush
/// with the field, as a user would ask for it. Nothing where no track fits.
std::optional<Plan> cheapest_along(const Field& field, const Machine& machine, const Plan& like,
                                   Direction along);

/// What a plan costs, by what: one line, to explain why one plan is cheaper than another.
std::string figures_in_full(const Plan& plan);

}  // namespace tramline::testing
