// The jobs that make a plan, and that compare plans.

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <utility>

#include "report/explain_report.h"
#include "report/turning/route_report.h"
#include "server/input/json_input.h"
#include "server/input/plan_input.h"
#include "server/routes/job_kinds.h"
#include "server/routes/search_progress.h"
#include "server/store/kept_front.h"
#include "server/store/shape_key.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/validate_request.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

struct PlanRequest {
  KeptFieldPtr field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
  bool explain = false;
  bool draft = false;
  std::optional<double> seconds;  ///< for the search; without: until it is through
  std::string name;
  std::string edit_of;  ///< the plan that this one is an edit of; empty: it is planned anew
  ordered_json asked;   ///< machine, objective and settings as in the request
};

/// What decides about the plan, as it was asked for.
ordered_json asked_in(const ordered_json& json) {
  ordered_json out = ordered_json::object();
  for (const char* key : {"machine", "objective", "settings", "edit_of"})
    if (json.contains(key)) out[key] = json[key];
  return out;
}

bool takes_land_off(const ordered_json& settings) {
  if (!settings.is_object() || !settings.contains("land")) return false;
  return has_done(land_in(settings["land"], "settings.land"));
}

PlanRequest plan_request(App& app, const ordered_json& json, Defaults otherwise) {
  const JsonInput input(json, "",
                        {"kind", "field", "machine", "objective", "settings", "explain", "draft", "seconds",
                         "name", "edit_of"});
  PlanRequest out;
  out.field = app.fields.get(input.text("field"));
  out.machine = machine_in(input.value("machine"), "machine");
  out.objective = objective_in(input.value("objective"));
  const bool priced_by_user = input.has("objective") && !input.value("objective").is_null();
  // Land that is done is taken off the field, and headland passes go round a whole one.
  const bool tracks_alone = priced_by_user || takes_land_off(input.value("settings"));
  const SettingsInput settings =
      settings_in(input.value("settings"), tracks_alone ? Defaults::kTracks : otherwise);
  validate_request(out.machine, out.objective, settings.settings);
  out.settings = settings_on(settings, out.field->field, out.machine);
  if (tracks_alone) out.settings.aim = Aim::kCost;
  out.explain = input.flag_if("explain").value_or(false);
  out.draft = input.flag_if("draft").value_or(false);
  out.seconds = input.number_if("seconds");
  if (out.seconds && *out.seconds <= 0)
    throw bad_input(fmt::format("seconds has to be a number above 0, not {:g}", *out.seconds));
  out.name = name_of(input, "name");
  if (input.has("edit_of")) out.edit_of = app.plans.get(input.text("edit_of")).id;
  if (out.explain && !out.edit_of.empty())
    throw bad_input("an edit is compared with no other plan; leave explain out");
  out.asked = asked_in(json);
  if (out.draft && !out.name.empty()) throw bad_input("a plan with a name is kept; leave out name or draft");
  return out;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// `shape`: of the field now.
Plan edited_plan(App& app, const PlanRequest& request, const std::string& shape, const Progress& progress) {
  const OpenedPlanPtr before = app.plans.open(request.edit_of);
  if (before->notes.field != request.field->id || before->notes.shape != shape)
    throw bad_input(
        "the plan to be edited is of another field, or of a shape that the field had; plan it anew");
  return plan_edited(before->plan, request.field->field, request.machine, request.objective, request.settings,
                     0, progress);
}

ordered_json make_plan(App& app, const PlanRequest& request, JobRun& run) {
  const auto start = std::chrono::steady_clock::now();
  const Progress progress = told_to(run, request.seconds);
  PlanNotes notes{request.name.empty() ? request.field->name : request.name,
                  request.field->id,
                  request.field->skipped,
                  0,
                  nullptr,
                  request.draft,
                  request.asked,
                  shape_key(request.field->field)};
  Plan plan;
  const Field& field = request.field->field;
  if (!request.edit_of.empty()) {
    plan = edited_plan(app, request, notes.shape, progress);
  } else if (request.explain) {
    ExplainedPlan explained =
        plan_and_explain(field, request.machine, request.objective, request.settings, 0, progress);
    plan = std::move(explained.plan);
    if (explained.why) notes.explain = app::explain_json(*explained.why);
    if (!explained.routes.empty()) notes.explain["routes"] = app::compared_routes_json(explained.routes);
  } else {
    plan = plan_field(field, request.machine, request.objective, request.settings, 0, progress);
  }
  run.check();
  notes.seconds = seconds_since(start);
  return {{"plan", app.plans.add(std::move(plan), std::move(notes)).id}};
}

void require_free_directions(const PlanSettings& settings) {
  require_straight_tracks(settings);
  if (!settings.guide.empty())
    throw bad_input("a comparison chooses directions itself; leave out the line to follow");
  if (settings.given.divides() || !settings.given.left_out.empty() || !settings.given.done.empty())
    throw bad_input("a comparison is of the whole field; leave out the land that was drawn");
}

ordered_json compare_plans(App& app, const PlanRequest& request, JobRun& run) {
  const auto start = std::chrono::steady_clock::now();
  TradeOff found = trade_off(request.field->field, request.machine, request.objective, request.settings, 0,
                             told_to(run, request.seconds));
  run.check();
  const std::string name = request.name.empty() ? request.field->name : request.name;
  return {{"front", app.fronts
                        .add({"", name, request.field, request.machine, request.settings, std::move(found),
                              seconds_since(start), request.asked})
                        ->id}};
}

}  // namespace

JobStatus begin_compare(App& app, const ordered_json& json) {
  PlanRequest request = plan_request(app, json, Defaults::kTracks);
  if (request.draft) throw bad_input("a comparison does not keep a plan; leave draft out");
  if (!request.edit_of.empty()) throw bad_input("a comparison is of plans made anew; leave edit_of out");
  require_free_directions(request.settings);
  const std::string what = fmt::format("comparing plans of {}", request.field->name);
  const std::string field = request.field->id;
  return app.jobs.submit(
      "compare", what,
      [&app, request = std::move(request)](JobRun& run) { return compare_plans(app, request, run); }, field);
}

JobStatus begin_plan(App& app, const ordered_json& json) {
  PlanRequest request = plan_request(app, json, Defaults::kWholePlan);
  const std::string what = fmt::format("planning {}", request.field->name);
  const std::string field = request.field->id;
  return app.jobs.submit(
      "plan", what,
      [&app, request = std::move(request)](JobRun& run) { return make_plan(app, request, run); }, field);
}

}  // namespace tramline::server
