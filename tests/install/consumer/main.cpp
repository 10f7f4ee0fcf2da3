// Plans a field of 120 m by 60 m, 6 m wide, writes the plan and says how many tracks there are.

#include <cstdio>
#include <exception>

#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

int main(int argc, char** argv) {
  try {
    tramline::Field field;
    field.id = "consumer";
    field.outer = {{0, 0}, {120, 0}, {120, 60}, {0, 60}};
    tramline::Machine machine;
    machine.width_m = 6;
    const tramline::Plan plan =
        tramline::plan_field(field, machine, tramline::Objective{}, tramline::PlanSettings{});
    if (argc > 1) tramline::io::write_plan(plan, argv[1]);
    std::printf("tracks: %zu\n", plan.pieces.size());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
