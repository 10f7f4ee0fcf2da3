// The job that verifies a plan.

#include <fmt/format.h>

#include <string>
#include <utility>

#include "report/check_report.h"
#include "request/judge_plan.h"
#include "server/input/json_input.h"
#include "server/map/shown_place.h"
#include "server/routes/job_kinds.h"

namespace tramline::server {

using nlohmann::ordered_json;

JobStatus begin_check(App& app, const ordered_json& json) {
  const JsonInput input(json, "", {"kind", "plan"});
  const KeptPlan plan = app.plans.get(input.text("plan"));
  return app.jobs.submit("check", fmt::format("checking {}", plan.name), [&app, plan](JobRun& run) {
    const io::PlanFile opened = app.plans.on_disk(plan.id);
    run.check();
    const check::Verdict verdict = app::judge(opened, std::nullopt);
    ordered_json out = app::check_json(plan.name, opened.plan, verdict);
    const ShownPlace place(opened.plan.field.frame);
    for (const char* list : {"violations", "findings"})
      for (ordered_json& entry : out[list]) entry["at"] = place.position({entry.at("x_m"), entry.at("y_m")});
    return ordered_json{{"check", std::move(out)}};
  });
}

}  // namespace tramline::server
