// Jobs: begun, looked at, followed, cancelled.

#include <memory>
#include <string>

#include "server/input/json_input.h"
#include "server/routes/job_kinds.h"
#include "server/routes/routes.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

JobStatus begin(App& app, const ordered_json& json) {
  const std::string kind =
      json.contains("kind") && json["kind"].is_string() ? json["kind"].get<std::string>() : "";
  if (kind == "plan") return begin_plan(app, json);
  if (kind == "evaluate") return begin_evaluate(app, json);
  if (kind == "repair") return begin_repair(app, json);
  if (kind == "compare") return begin_compare(app, json);
  if (kind == "check") return begin_check(app, json);
  throw bad_input("kind has to be plan, compare, evaluate, repair or check");
}

/// The first event comes at once, each further one after a change; the last says how it ended.
std::function<bool(EventSink&)> follow(App& app, const std::string& id) {
  auto seen = std::make_shared<unsigned>(0);
  auto first = std::make_shared<bool>(true);
  return [&app, id, seen, first](EventSink& events) {
    using namespace std::chrono_literals;
    const auto job = *first ? app.jobs.find(id) : app.jobs.wait(id, *seen, 1000ms);
    if (!job) return false;
    if (!*first && job->version == *seen) return events.ping();
    *first = false;
    *seen = job->version;
    const char* event = is_over(job->state) ? name(job->state) : "progress";
    return events.send(event, job_json(*job)) && !is_over(job->state);
  };
}

}  // namespace

void add_job_routes(Router& router, App& app) {
  router.post(api("/jobs"), [&app](const Call& call, httplib::Response& response) {
    answer(response, job_json(begin(app, call.json())), 202);
  });
  router.get(api("/jobs"), [&app](const Call&, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const JobStatus& job : app.jobs.list()) out.push_back(job_json(job));
    answer(response, out);
  });
  router.get(api("/jobs/{job}"), [&app](const Call& call, httplib::Response& response) {
    const auto job = app.jobs.find(call.part("job"));
    if (!job) throw not_found("job", call.part("job"));
    answer(response, job_json(*job));
  });
  router.get(api("/jobs/{job}/events"), [&app](const Call& call, httplib::Response& response) {
    if (!app.jobs.find(call.part("job"))) throw not_found("job", call.part("job"));
    stream_events(app.streams, response, follow(app, call.part("job")));
  });
  router.remove(api("/jobs/{job}"), [&app](const Call& call, httplib::Response& response) {
    const auto job = app.jobs.cancel(call.part("job"));
    if (!job) throw not_found("job", call.part("job"));
    answer(response, job_json(*job));
  });
}

}  // namespace tramline::server
