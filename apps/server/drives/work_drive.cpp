#include "server/drives/work_drive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "report/evaluate_report.h"
#include "report/report_parts.h"
#include "request/plan_and_done.h"
#include "server/drives/work_log_file.h"
#include "server/input/drive_input.h"
#include "server/map/shown_place.h"
#include "server/work/ready_drive.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/render/coverage/draw_coverage.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// A log none of whose fixes is nearer to a field than this was driven elsewhere, m.
constexpr double kNear_m = 2000;

const char* word_for(Clock clock) {
  switch (clock) {
    case Clock::kNone:
      return "none";
    case Clock::kUtc:
      return "utc";
    case Clock::kOfDay:
      return "of_day";
    case Clock::kOther:
      return "other";
  }
  return "none";
}

/// What a replay's slider runs over: the log's times, or numbers of fixes where it has none.
struct Span {
  double from_s = 0, to_s = 0;
  Clock clock = Clock::kNone;
};

Span span_of(const WorkLog& log) {
  Span out{0, static_cast<double>(std::max<std::size_t>(log.fixes.size(), 1) - 1), Clock::kNone};
  bool any = false;
  for (const Fix& fix : log.fixes) {
    if (!std::isfinite(fix.time_s)) continue;
    out.from_s = any ? std::min(out.from_s, fix.time_s) : fix.time_s;
    out.to_s = any ? std::max(out.to_s, fix.time_s) : fix.time_s;
    any = true;
  }
  if (any) out.clock = log.clock;
  return out;
}

ordered_json gaps_json(const Coverage& coverage, const ShownPlace& place) {
  ordered_json out = ordered_json::array();
  for (const Gap& gap : coverage.gaps) {
    const Point at = place.to_lonlat(gap.centre);
    out.push_back({{"number", gap.number},
                   {"area_m2", gap.area_m2},
                   {"lon", at.x},
                   {"lat", at.y},
                   {"widest_m", app::number_json(gap.widest_m)}});
  }
  return out;
}

ordered_json shown(const DriveOrder& order, const app::Evaluation& evaluation, const Span& span) {
  const Coverage& coverage = evaluation.coverage;
  const ShownPlace place(coverage.frame);
  Box box = bounds(coverage.field);
  const bool any_ground = !coverage.field.empty() || !coverage.covered.empty();
  if (any_ground) box = render::drawn_box(coverage);
  ordered_json out;
  out["id"] = order.id;
  out["name"] = order.name;
  out["field"] = order.field.empty() ? ordered_json() : ordered_json(order.field);
  out["plan"] = order.plan.empty() ? ordered_json() : ordered_json(order.plan);
  out["created"] = order.created;
  out["log"] = order.source.log_name;
  out["fixes"] = coverage.fixes_used;
  out["from_s"] = span.from_s;
  out["to_s"] = span.to_s;
  out["clock"] = word_for(span.clock);
  out["geodetic"] = coverage.frame.geodetic;
  out["bbox"] = any_ground ? place.bbox(box) : ordered_json();
  out["covered_m2"] = coverage.areas.covered_m2;
  out["missed_m2"] = coverage.field.empty() ? ordered_json() : app::number_json(coverage.areas.missed_m2);
  out["options"] = drive_options_json(order.source.options);
  out["width_m"] = app::number_json(order.source.options.drive.width_m);
  out["summary"] = app::evaluation_json(evaluation);
  out["gaps"] = gaps_json(coverage, place);
  out["compared"] = nullptr;
  if (evaluation.compared) out["compared"] = out["summary"]["plan"];
  return out;
}

/// What a step of the work may be followed and cancelled by.
coverage::FixProgress told_to(JobRun& run) {
  return [&run](std::size_t done, std::size_t total) {
    run.progress(static_cast<int>(done), static_cast<int>(total));
  };
}

struct WorkedOrder {
  KeptDrive drive;
  Coverage coverage;
};

WorkedOrder evaluated(App& app, DriveOrder order, JobRun& run) {
  const auto start = std::chrono::steady_clock::now();
  run.step("reading " + order.source.log_name);
  WorkLog read = read_work_log(app.drives->store.log_file(order.id, order.source), order.source);
  app::WorkGround ground = ground_of(app, order.field);
  OpenedPlanPtr plan;
  if (!order.plan.empty()) plan = app.plans.open(order.plan);
  if (plan && ground.ground.empty()) {
    ground = app::work_ground(plan->plan);
    order.field = app.plans.get(order.plan).field;
  }
  std::string remark;
  if (order.field_is_a_guess && !comes_near(read, ground.frame, bounds(ground.ground), kNear_m)) {
    remark = "the field that the task names lies elsewhere: evaluated without a field";
    ground = {};
    order.field.clear();
  }
  const std::optional<WorkLog> as_read = plan ? std::optional(read) : std::nullopt;
  const coverage::EvaluateSettings settings = evaluate_settings(order.source.options);
  const Span span = span_of(read);

  run.step("evaluating " + order.source.log_name);
  app::Evaluation evaluation;
  evaluation.coverage = evaluated_log(std::move(read), std::move(ground), settings, told_to(run));
  evaluation.repeat = settings.repeat;
  if (!remark.empty()) evaluation.coverage.warnings.push_back(remark);
  if (plan) {
    run.step("comparing it with " + plan->notes.name);
    evaluation.compared = app::plan_and_done(plan->plan, plan->notes.name, *as_read, settings, told_to(run));
  }
  run.check();
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  return {{order.id, order.name, order.field, order.plan, order.created, order.source,
           evaluation.coverage.frame, shown(order, evaluation, span)},
          std::move(evaluation.coverage)};
}

}  // namespace

app::WorkGround ground_of(const App& app, const std::string& field) {
  if (field.empty()) return {};
  const KeptFieldPtr kept = app.fields.get(field);
  app::WorkGround out{kept->field.id, {}, kept->field.frame};
  for (Polygon& polygon : body_of(kept->field)) out.ground.push_back(oriented(std::move(polygon)));
  return out;
}

KeptDrive work_drive(App& app, DriveOrder order, JobRun& run) {
  WorkedOrder worked = evaluated(app, std::move(order), run);
  app.drives->store.add(worked.drive, worked.coverage);
  return worked.drive;
}

KeptDrive work_again(App& app, const KeptDrive& drive, JobRun& run) {
  return while_kept(
      [&] { app.drives->store.get(drive.id); },
      [&] {
        WorkedOrder worked = evaluated(
            app, {drive.id, drive.name, drive.created, drive.field, drive.plan, drive.source, false}, run);
        app.drives->store.replace(worked.drive, worked.coverage);
        app.drives->replays.forget(drive.id);
        return worked.drive;
      });
}

std::shared_ptr<const ReadyDrive> ready_to_replay(App& app, const KeptDrive& drive) {
  return app.drives->replays.get(drive.id, [&] {
    const Coverage coverage = io::read_coverage(app.drives->store.coverage_file(drive.id));
    return ready_drive(read_work_log(app.drives->store.log_file(drive.id, drive.source), drive.source),
                       {coverage.field_id, coverage.field, coverage.frame},
                       evaluate_settings(drive.source.options));
  });
}

}  // namespace tramline::server
