// How a machine turns from a track to its neighbours.

#include "report/turning/turns_report.h"
#include "request/turns_request.h"
#include "server/input/json_input.h"
#include "server/input/plan_input.h"
#include "server/routes/routes.h"

namespace tramline::server {

void add_turn_routes(Router& router) {
  router.post(api("/turns"), [](const Call& call, httplib::Response& response) {
    const nlohmann::ordered_json json = call.json();
    const JsonInput input(json, "", {"machine", "spacing_m", "angle_deg"});
    app::TurnsReport report;
    report.machine = machine_in(input.value("machine"), "machine");
    report.settings = app::turns_asked(report.machine, input.number_if("spacing_m"),
                                       input.number_if("angle_deg").value_or(90));
    report.rows = turn_table(report.machine, report.settings);
    answer(response, app::turns_json(report));
  });
}

}  // namespace tramline::server
