#pragma once
// Random fields full of obstacles, with machines and prices to plan them with.

#include <random>

#include "tramline/model/field.h"
#include "tramline/model/machine.h"
#include "tramline/model/objective.h"
#include "tramline/model/plan.h"

namespace tramline::testing {

struct Scene {
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
};

/// 0.5 to 10 ha, star-shaped, oblong or L-shaped, with 1 to 30 obstacles: poles, discs, needles of 5 cm by
/// 20 m, rectangles, stars, L and U shapes; some across the edge, some over one another, some passable. They
/// come in through admission. Widths of 1 to 30 m, radii of 0 to 15 m. Throws Error where obstacles cover
/// the whole field. Deterministic.
Scene random_scene(std::mt19937_64& random);

}  // namespace tramline::testing
