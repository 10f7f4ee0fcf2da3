#include "work.h"

#include <chrono>
#include <utility>
#include <vector>

#include "options/search_seconds.h"
#include "report/check_report.h"
#include "report/evaluations.h"
#include "report/front_report.h"
#include "report/job_cost_report.h"
#include "report/plan_report.h"
#include "report/price_report.h"
#include "report/report_parts.h"
#include "request/judge_plan.h"
#include "request/log_jobs.h"
#include "tramline/geodesy/crs.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/price/price_lines.h"
#include "tramline/planner/validate_request.h"

namespace tramline::python {
namespace {

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// With a time limit, which counts from now.
Progress limited(const Progress& progress, std::optional<double> seconds) {
  return [progress, time = app::SearchTime(seconds)](int done, int total) {
    const Demand demand = progress ? progress(done, total) : Demand::kGoOn;
    return time.is_over() ? Demand::kEnd : demand;
  };
}

/// The one field of the input.
const Field& only_field(const app::FieldInput& input) {
  if (input.fields.size() > 1)
    throw bad_input("the field consists of " + std::to_string(input.fields.size()) +
                    " parts that are planned one by one: give one of them, or all to plan_fields()");
  return input.fields.front();
}

std::string text_of(const nlohmann::ordered_json& json) { return app::json_line(app::versioned(json)); }

}  // namespace

PlanObject planned(const PlanRequest& request, const Progress& progress) {
  app::AskedPlans asked(request.plan);
  app::FieldInput input = app::load_fields(request.field);
  asked.read_files(request.plan, request.land, input);
  const Field& field = only_field(input);
  const Clock clock;
  PlanObject out;
  out.plan = plan_field(field, asked.machine(), asked.objective(), asked.settings_on(field), request.threads,
                        limited(progress, request.seconds));
  out.seconds = clock.seconds();
  out.skipped = std::move(input.skipped);
  return out;
}

std::string json_of(const PlanObject& object) {
  const nlohmann::ordered_json figures =
      object.plan.origin == PlanOrigin::kLines
          ? app::price_json({object.plan, nullptr, object.skipped, object.seconds})
          : app::plan_json(object.plan, object.skipped, object.seconds);
  return text_of(app::with_field_names(object.plan.field, figures));
}

void require_plannable(const PlanRequest& request) { app::AskedPlans(request.plan); }

namespace {

/// What each machine takes on the field; a machine that the field cannot be planned with has the reason.
ComparisonObject compared_machines(const CompareRequest& request, const Progress& progress) {
  const app::AskedMachines& asked = *request.machines;
  for (const Machine& machine : asked.machines) validate_request(machine, asked.objective, asked.settings);
  const app::FieldInput input = app::load_fields(request.options.field);
  const Field& field = only_field(input);
  const std::string& crs = field.source.input_crs;
  const std::optional<GuideLine> guide = app::guide_of(request.options.plan, crs);
  const app::Gates gates = app::gates_of(request.options.plan, crs);
  std::vector<app::JobCost> jobs;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Machine& machine : asked.machines) {
    app::JobCost job{field.id, app::machine_text(machine), 0, 0, {}, {}};
    try {
      PlanSettings settings = app::settings_for(asked.settings, guide, field, machine);
      app::place_gates(gates, field, settings);
      job = app::job_cost(plan_field(field, machine, asked.objective, settings, request.threads,
                                     limited(progress, request.seconds)));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      job.refusal = error.what();
    }
    rows.push_back(app::job_cost_json(job));
    jobs.push_back(std::move(job));
  }
  ComparisonObject out;
  out.json = text_of(app::with_field_names(field, {{"machines", rows}}));
  out.csv = app::job_cost_csv(jobs);
  return out;
}

}  // namespace

ComparisonObject compared(const CompareRequest& request, const Progress& progress) {
  if (request.machines) return compared_machines(request, progress);
  const app::AskedPlans& asked = request.plans->plans;
  const app::FieldInput input = app::load_fields(request.options.field);
  const Field& field = only_field(input);
  const PlanSettings settings = asked.settings_on(field);
  const Clock clock;
  ComparisonObject out;
  out.found = trade_off(field, asked.machine(), asked.objective(), settings, request.threads,
                        limited(progress, request.seconds));
  const app::Comparison comparison{
      field,           asked.machine(),     settings, out.found->front, request.plans->prices,
      clock.seconds(), out.found->cut_short};
  out.json = text_of(app::with_field_names(field, app::compare_json(comparison, input.skipped)));
  out.csv = app::front_csv(out.found->front);
  return out;
}

PlanObject plan_at(const ComparisonObject& object, std::size_t point) {
  if (!object.found)
    throw bad_input("machines were compared by what they take; their plans are made by plan()");
  const std::size_t points = object.found->front.points.size();
  if (point < 1 || point > points)
    throw bad_input("there is no plan " + std::to_string(point) + ": there are 1 to " +
                    std::to_string(points));
  PlanObject out;
  out.plan = plan_of(*object.found, point - 1);
  return out;
}

PlanObject priced(const PriceRequest& request, const Progress& progress) {
  const app::PriceOptions& o = request.options;
  const Clock clock;
  app::PriceInput input = app::price_input(o.lines, o.field, o.plan);
  validate_request(input.machine, input.objective, input.settings);
  PricedLines found =
      price_lines(input.field, input.machine, input.objective, input.lines, input.settings.clearance_m);
  PlanObject out;
  out.plan = std::move(found.plan);
  if (o.compare) {
    const PlanSettings settings = app::settings_for(
        input.settings, app::guide_of(o.plan, input.field.source.input_crs), input.field, input.machine);
    out.planned = plan_field(input.field, input.machine, input.objective, settings, request.threads,
                             limited(progress, request.seconds));
  }
  out.skipped = std::move(input.skipped);
  for (Skipped& line : found.skipped) out.skipped.push_back(std::move(line));
  out.seconds = clock.seconds();
  return out;
}

std::string comparison_of(const PlanObject& object) {
  if (!object.planned) return "";
  const app::PricedPlans both{object.plan, &*object.planned, object.skipped, object.seconds};
  return text_of(app::with_field_names(object.plan.field, app::price_json(both)));
}

std::optional<PlanObject> planned_beside(const PlanObject& object) {
  if (!object.planned) return std::nullopt;
  PlanObject out;
  out.plan = *object.planned;
  return out;
}

EvaluationObject evaluated(const EvaluateRequest& request, const std::optional<Plan>& plan,
                           const std::string& plan_name) {
  const Clock clock;
  coverage::EvaluateSettings settings;
  app::apply(request.drive, settings);
  settings.threads = request.threads;
  settings.shapes = true;
  EvaluationObject out;
  if (request.log_file.empty()) {
    if (!plan) throw bad_input("name a log to evaluate, or give a plan");
    out.evaluation = app::evaluation_of_plan(*plan, plan_name, settings);
  } else {
    std::vector<app::NumberedJob> jobs = app::jobs_of(request.log_file, request.drive.log, request.job);
    if (jobs.size() > 1)
      throw bad_input("'" + request.log_file + "' has " + std::to_string(jobs.size()) +
                      " jobs; choose one with job");
    io::LogJob& job = jobs.front().job;
    std::optional<app::WorkGround> ground =
        app::work_ground(app::field_of_job(request.field, request.log_file, job));
    if (!ground) ground = plan ? app::work_ground(*plan) : app::WorkGround{};
    std::optional<app::NamedPlan> named;
    if (plan) named.emplace(app::NamedPlan{*plan, plan_name});
    const std::vector<Plan> no_others;
    out.evaluation =
        app::evaluation_of_drive(std::move(job.log), *std::move(ground), {named, no_others}, settings, {});
  }
  out.evaluation.repeat = settings.repeat;
  out.evaluation.seconds = clock.seconds();
  out.json = text_of(app::evaluation_json(out.evaluation));
  return out;
}

std::string checked(const std::string& plan_file, const std::string& id, const app::FieldOptions& field) {
  const io::PlanFile file = io::read_plan_file(plan_file, id);
  std::optional<Field> input;
  if (!field.file.empty()) input = app::load_field(field, file.plan.field.source);
  return text_of(app::check_json(plan_file, file.plan, app::judge(file, input)));
}

PlanObject read(const std::string& plan_file, const std::string& id) {
  PlanObject out;
  out.plan = io::read_plan(plan_file, id);
  return out;
}

std::string crs_of(const PlanObject& object) {
  const std::string& crs = object.plan.field.source.input_crs;
  return object.plan.field.frame.geodetic && crs != Crs().definition() ? crs : "";
}

}  // namespace tramline::python
