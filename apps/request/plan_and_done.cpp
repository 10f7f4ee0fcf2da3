#include "request/plan_and_done.h"

#include <utility>
#include <vector>

#include "request/evaluate_input.h"
#include "tramline/coverage/drive/plan_steps.h"

namespace tramline::app {

PlanAndDone plan_and_done(const Plan& plan, std::string plan_name, WorkLog read,
                          const coverage::EvaluateSettings& settings, const coverage::FixProgress& progress) {
  WorkGround ground = work_ground(plan);
  const std::vector<coverage::WorkedStep> steps = coverage::steps_of(plan);
  coverage::EvaluateSettings exact;
  exact.threads = settings.threads;
  const Region planned = coverage::evaluate(steps, plan.machine.width_m, {}, exact).covered;
  const Coverage done = coverage::evaluate(placed_on(std::move(read), ground), planned, settings, progress);
  return {std::move(plan_name),
          coverage::deviation(plan, done.lines),
          area(planned),
          done.areas.missed_m2,
          done.areas.not_recorded_m2,
          done.areas.outside_m2};
}

}  // namespace tramline::app
