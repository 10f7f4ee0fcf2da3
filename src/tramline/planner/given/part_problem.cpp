#include "tramline/planner/given/part_problem.h"

#include <memory>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {

PartProblem::PartProblem(const PlanningProblem& whole, const PreparedField& prepared, Region shapes,
                         MayDivide divide)
    : problem_(whole), prepared_(prepared) {
  problem_.settings.given = {};
  problem_.settings.guide.clear();
  prepared_.given = {};
  prepared_.headland = {};
  prepared_.beside_boundaries = std::make_shared<LinesBesideBoundaries>();
  prepared_.may_divide = divide;
  ClassifiedGround& ground = prepared_.ground;
  ground.body = intersection(ground.body, shapes);
  ground.given_up.clear();
  ground.plannable = std::move(shapes);
  prepared_.body_m2 = area(ground.body);
}

}  // namespace tramline
