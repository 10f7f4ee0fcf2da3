// Jobs that evaluate a drive, and that plan what it has missed.

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "report/repair_report.h"
#include "request/gap_fields.h"
#include "server/drives/work_drive.h"
#include "server/input/drive_input.h"
#include "server/input/json_input.h"
#include "server/input/plan_input.h"
#include "server/routes/job_kinds.h"
#include "server/routes/search_progress.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/model/limits.h"
#include "tramline/planner/repair/repair_plan.h"
#include "tramline/planner/validate_request.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

Upload log_uploaded(App& app, const JsonInput& input) {
  Upload out = app.uploads.get(input.text("upload"));
  if (out.kind != UploadKind::kLog)
    throw bad_input(
        fmt::format("{} is not a machine log; choose a CSV, NMEA, GPX or ISOXML file of a drive", out.name));
  return out;
}

DriveOrder drive_order(App& app, const ordered_json& json, const Upload& upload, const JsonInput& input) {
  DriveOrder out;
  out.id = new_id();
  out.created = time_now();
  out.name = name_of(input, "name");
  out.field = input.text_or_none("field");
  out.plan = input.text_or_none("plan");
  if (!out.field.empty()) app.fields.get(out.field);
  if (!out.plan.empty()) app.plans.keep(out.plan);
  out.source.options = drive_options_in(json.value("options", ordered_json()), input.number_if("width_m"));
  out.source.options.log.log = input.text_or_none("log");
  out.source.log_name = upload.name;
  out.source.extension = log_extension(upload.path.filename().string());
  if (out.name.empty()) out.name = stem_of(upload.name);
  return out;
}

JobStatus evaluate_again(App& app, const KeptDrive& drive) {
  return app.jobs.submit("evaluate", "evaluating " + drive.name, [&app, drive](JobRun& run) {
    return ordered_json{{"drive", work_again(app, drive, run).id}};
  });
}

struct RepairRequest {
  KeptDrive drive;
  RepairTerms terms;
  double min_area_m2 = 1;
  std::string name;
};

RepairRequest repair_request(App& app, const ordered_json& json) {
  const JsonInput input(json, "", {"kind", "drive", "machine", "objective", "min_area_m2", "name"});
  RepairRequest out{app.drives->store.get(input.text("drive")),
                    {machine_in(input.value("machine"), "machine"), objective_in(input.value("objective")),
                     EndRule::kCheapest},
                    input.number_if("min_area_m2").value_or(1),
                    name_of(input, "name")};
  // Gaps are short: as for the command line, no length is too short unless one is given.
  if (out.terms.machine.min_length_m < 0) out.terms.machine.min_length_m = 0;
  PlanSettings settings;
  settings.end_rule = out.terms.end_rule;
  validate_request(out.terms.machine, out.terms.objective, settings);
  if (!(out.min_area_m2 > 0 && out.min_area_m2 <= kFarthest_m))
    throw bad_input(fmt::format("min_area_m2 has to be more than 0 and at most {} m², not {}", kFarthest_m,
                                out.min_area_m2));
  const ordered_json& missed_m2 = out.drive.shown["missed_m2"];
  if (missed_m2.is_null())
    throw bad_input(
        fmt::format("{} was evaluated without a field, so that nothing counts as missed; evaluate it again "
                    "with its field",
                    out.drive.name));
  if (out.drive.shown["gaps"].empty())
    throw bad_input(
        fmt::format("nothing of the field was missed by {}; there is nothing to repair", out.drive.name));
  return out;
}

/// What the gaps cost left as they are, and what it costs to work them.
ordered_json prices_of(const RepairPlan& repair) {
  return {{"missed_before_m2", repair.missed_before_m2},
          {"missed_after_m2", repair.missed_after_m2},
          {"cost_if_left", repair.cost_if_left},
          {"cost_of_passes", repair.cost_of_passes},
          {"cost_after", repair.cost_after}};
}

ordered_json make_repair(App& app, const RepairRequest& request, JobRun& run) {
  const KeptDrive& drive = request.drive;
  const Coverage coverage =
      while_kept([&] { app.drives->store.get(drive.id); },
                 [&] { return io::read_coverage(app.drives->store.coverage_file(drive.id)); });
  struct Part {
    RepairPlan done;
    double seconds;
  };
  std::vector<Part> parts;
  for (app::GapField& part : app::gap_fields(coverage, drive.name)) {
    if (part.gaps.empty()) continue;
    run.step(fmt::format("planning what {} has missed", drive.name));
    const auto start = std::chrono::steady_clock::now();
    const Progress progress = told_to(run);
    RepairPlan done = repair_plan(part.field, part.gaps, part.missed, part.driven, request.terms,
                                  request.min_area_m2, 0, progress);
    run.check();
    parts.push_back(
        {std::move(done), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  }
  if (parts.empty()) throw bad_input("no gap lies in the field; there is nothing to repair");
  // All or, where it is cancelled, none.
  ordered_json plans = ordered_json::array();
  for (const Part& part : parts) {
    PlanNotes notes;
    notes.name = request.name.empty() ? "gaps of " + drive.name : request.name;
    notes.field = drive.field;
    notes.seconds = part.seconds;
    notes.explain = {{"repair", prices_of(part.done)}};
    const std::string plan = app.plans.add(part.done.plan, std::move(notes)).id;
    plans.push_back(
        {{"plan", plan}, {"report", app::repair_json(part.done, request.min_area_m2, part.seconds)}});
  }
  ordered_json out = plans.front();
  if (plans.size() > 1) out["plans"] = std::move(plans);
  return out;
}

}  // namespace

JobStatus begin_drive(App& app, const ordered_json& json) {
  const JsonInput input(json, "", {"upload", "log", "field", "plan", "width_m", "options", "name"});
  const Upload upload = log_uploaded(app, input);
  DriveOrder order = drive_order(app, json, upload, input);
  std::shared_ptr<void> log =
      while_kept([&] { app.uploads.get(upload.id); },
                 [&] { return app.drives->store.take_log(order.id, order.source, upload.path); });
  const std::string what = "evaluating " + order.name;
  // The log belongs to the job: it goes with it, however that ends.
  return app.jobs.submit(
      "evaluate", what, [&app, order = std::move(order), log = std::move(log)](JobRun& run) mutable {
        if (order.field.empty() && order.plan.empty()) {
          order.field = partfield_of(app, app.drives->store.log_file(order.id, order.source),
                                     order.source.options.log.log);
          order.field_is_a_guess = !order.field.empty();
        }
        return ordered_json{{"drive", work_drive(app, order, run).id}};
      });
}

JobStatus begin_evaluate(App& app, const ordered_json& json) {
  const JsonInput input(json, "", {"kind", "drive", "options"});
  KeptDrive drive = app.drives->store.get(input.text("drive"));
  if (input.has("options")) {
    // Which log it is and how wide the machine is stay as they are.
    app::DriveOptions& options = drive.source.options;
    const double width_m = options.drive.width_m;
    std::string log = std::move(options.log.log);
    options =
        drive_options_in(json.at("options"), width_m > 0 ? std::optional<double>(width_m) : std::nullopt);
    options.log.log = std::move(log);
  }
  return evaluate_again(app, drive);
}

void finish_half_replaced(App& app) {
  for (const std::string& id : app.drives->store.half_replaced()) {
    try {
      evaluate_again(app, app.drives->store.get(id));
    } catch (const HttpError&) {
      return;  // too many at once: the others come at the next start
    }
  }
}

JobStatus begin_repair(App& app, const ordered_json& json) {
  RepairRequest request = repair_request(app, json);
  const std::string what = fmt::format("planning what {} has missed", request.drive.name);
  return app.jobs.submit("repair", what, [&app, request = std::move(request)](JobRun& run) {
    return make_repair(app, request, run);
  });
}

}  // namespace tramline::server
