#include "work.h"

#include <chrono>
#include <utility>
#include <vector>

#include "report/check_report.h"
#include "report/evaluations.h"
#include "report/front_report.h"
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
  return [progress, seconds, clock = Clock()](int done, int total) {
    const Demand demand = progress ? progress(done, total) : Demand::kGoOn;
    return seconds && clock.seconds() >= *seconds ? Demand::kEnd : demand;
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

ComparisonObject compared(const PlanRequest& request, const Progress& progress) {
  app::AskedPlans asked(request.plan);
  app::FieldInput input = app::load_fields(request.field);
  asked.read_files(request.plan, request.land, input);
  const Field& field = only_field(input);
  const PlanSettings settings = asked.settings_on(field);
  require_straight_tracks(settings);
  if (!settings.guide.empty()) throw bad_input("compare() chooses directions itself; leave out ab and guide");
  const Clock clock;
  ComparisonObject out;
  out.found = trade_off(field, asked.machine(), asked.objective(), settings, request.threads,
                        limited(progress, request.seconds));
  const std::vector<Objective> nothing_else;
  const app::Comparison comparison{field,        asked.machine(), settings,           out.found.front,
                                   nothing_else, clock.seconds(), out.found.cut_short};
  out.json = text_of(app::with_field_names(field, app::compare_json(comparison, input.skipped)));
  out.csv = app::front_csv(out.found.front);
  return out;
}

PlanObject priced(const PriceRequest& request) {
  const Clock clock;
  app::PriceInput input = app::price_input(request.lines, request.field, request.plan);
  validate_request(input.machine, input.objective, input.settings);
  PricedLines found =
      price_lines(input.field, input.machine, input.objective, input.lines, input.settings.clearance_m);
  PlanObject out;
  out.plan = std::move(found.plan);
  out.skipped = std::move(input.skipped);
  for (Skipped& line : found.skipped) out.skipped.push_back(std::move(line));
  out.seconds = clock.seconds();
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
