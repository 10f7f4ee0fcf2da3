#include "real/order_runs.h"

#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {

OrderRun run_order(const Field& field, const OrderScenario& scenario) {
  OrderRun out;
  out.field_id = field.id;
  PlanSettings settings;
  settings.headlands = scenario.headlands;
  settings.shape = scenario.shape;
  try {
    const Plan plan = plan_field(field, {"", scenario.width_m, 6, -1}, {}, settings, 1);
    out.planned = scenario.shape == TrackShape::kStraight || is_curved(plan);
    out.pieces = plan.pieces.size();
    out.hops = testing_support::hops_of(plan);
    out.nearest_neighbour_m = testing_support::nearest_neighbour_m(plan.pieces);
  } catch (const Error& error) {  // refused: other sweeps say so
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  return out;
}

}  // namespace tramline::testing
