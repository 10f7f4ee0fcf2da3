#pragma once
// Plans small enough to be known by hand.

#include <set>
#include <string>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::testing_plans {

Ring rectangle(double min_x, double min_y, double max_x, double max_y);

/// Tally, cost and layers made to agree with the tracks, so that a fault made on purpose is the only one.
/// Precondition: shapes and pieces are sound.
Plan settled(Plan plan);

/// 100 m × 30 m, ten swaths of 3 m driven east and west in turn: nothing over, nothing missed.
Plan rectangle_plan();

/// Right triangle 100 m × 40 m, swaths of 4 m along the long leg; cot φ = 2.5 at the hypotenuse. All
/// ends lie where the share `f` of the width is inside.
Plan triangle_plan(EndRule rule, double f);

/// The rectangle with an obstacle of 20 m × 2 m across two swaths: four stops.
Plan obstacle_plan();

/// The rectangle parted by an oblique border (cot φ = 2/3); both sides run on until nothing is missed.
Plan two_subfields_plan();

/// The rectangle with a ditch of 3 m across all swaths: ten crossings.
Plan crossing_plan();

/// The names of the rules violated.
std::set<std::string> rules(const check::Verdict& verdict);
using Names = std::set<std::string>;

}  // namespace tramline::testing_plans
