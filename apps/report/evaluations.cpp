#include "report/evaluations.h"

#include <limits>
#include <utility>

#include "request/plan_and_done.h"
#include "tramline/coverage/drive/plan_steps.h"

namespace tramline::app {
namespace {

/// The way that the plan plans, a run for each piece and headland pass, and the other ways of its route.
std::vector<DrivenLine> lines_of(const Plan& plan, PlanFigures figures) {
  std::vector<DrivenLine> out;
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  for (const coverage::PlanRun& run : coverage::runs_of(plan))
    if (figures != PlanFigures::kTracks || run.run < std::ssize(plan.pieces))
      out.push_back({run.run, chords(run.path), kNever, kNever});
  constexpr int kNoRun = -1;
  for (const RouteLeg& leg : plan.route.legs)
    if (const Path way = trace(leg.path); !leg.work && !leg.pass && !way.empty())
      out.push_back({kNoRun, chords(way), kNever, kNever});
  return out;
}

/// One plan after the other.
coverage::FurtherWork work_of_all(const std::vector<Plan>& plans, const LocalFrame& frame) {
  coverage::FurtherWork out;
  for (const Plan& plan : plans) {
    const int first = static_cast<int>(out.lines.size());
    coverage::FurtherWork more = work_of(plan, frame);
    for (coverage::WorkedStep& step : more.steps) {
      step.run += first;
      out.steps.push_back(std::move(step));
    }
    for (std::vector<Point>& line : more.lines) out.lines.push_back(std::move(line));
  }
  return out;
}

}  // namespace

Evaluation evaluation_of_plan(const Plan& plan, const std::string& name,
                              const coverage::EvaluateSettings& settings) {
  Evaluation out;
  const bool tracks_alone = plan.figures == PlanFigures::kTracks;
  const Region land = !plan.worked.empty() || tracks_alone ? plan.body : work_ground(plan).ground;
  out.coverage = coverage::evaluate(tracks_alone ? coverage::plan_steps(plan) : coverage::steps_of(plan),
                                    plan.machine.width_m, land, settings);
  out.coverage.lines = lines_of(plan, plan.figures);
  out.coverage.field_id = plan.field.id;
  out.coverage.field = land;
  out.coverage.frame = plan.field.frame;
  out.tally = PlanTally{name, area(land), area(plan.body), plan.tally};
  return out;
}

Evaluation evaluation_of_drive(WorkLog log, WorkGround ground, const PlansOfDrive& plans,
                               const coverage::EvaluateSettings& settings,
                               const coverage::FixProgress& progress) {
  if (ground.ground.empty() && !plans.with.empty()) ground = work_ground(plans.with.front());
  const std::optional<WorkLog> as_read = plans.compared ? std::optional(log) : std::nullopt;
  Evaluation out;
  WorkLog placed = placed_on(std::move(log), ground);
  out.coverage = coverage::evaluate(std::move(placed), ground.ground, settings, progress, {},
                                    work_of_all(plans.with, ground.frame));
  out.coverage.field_id = ground.field_id;
  out.coverage.field = ground.ground;
  out.coverage.frame = ground.frame;
  if (plans.compared)
    out.compared = plan_and_done(plans.compared->plan, plans.compared->name, *as_read, settings, progress);
  return out;
}

}  // namespace tramline::app
