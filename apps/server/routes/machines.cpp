// Machines that are kept.

#include <array>

#include "report/report_parts.h"
#include "server/input/plan_input.h"
#include "server/routes/routes.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const io::ListedMachine& listed) {
  const Machine& machine = listed.machine;
  ordered_json shortest;
  if (machine.min_length_m >= 0) shortest = machine.min_length_m;
  ordered_json out{{"id", listed.id},
                   {"name", machine.name},
                   {"width_m", machine.width_m},
                   {"radius_m", machine.radius_m},
                   {"min_length_m", shortest}};
  if (machine.turning != Turning{}) out["turning"] = app::turning_json(machine.turning);
  if (machine.rates != Rates{}) out["rates"] = app::given_rates_json(machine.rates);
  return out;
}

Machine named_machine(const ordered_json& json) {
  Machine machine = machine_in(json, "");
  if (machine.name.empty()) throw bad_input("give the machine a name");
  return machine;
}

constexpr std::array kOperations = {Operation::kGeneral,   Operation::kSeeding, Operation::kSpraying,
                                    Operation::kSpreading, Operation::kTillage, Operation::kMowing,
                                    Operation::kHarvest,   Operation::kWeeding, Operation::kDrone};

/// What is usual for an operation, with a machine as wide as the one asked about.
ordered_json usual(Operation operation, double width_m) {
  Machine machine;
  machine.width_m = width_m;
  machine.rates.operation = operation;
  machine.turning.working_speed_mps = usual_speed_mps(operation);
  return {{"operation", name(operation)},
          {"working_speed_mps", machine.turning.working_speed_mps},
          {"standing_crop", works_standing_crop(operation)},
          {"rates", app::given_rates_json(rates_of(machine))}};
}

ordered_json operations(const std::string& width_m) {
  ordered_json asked = ordered_json::parse(width_m.empty() ? "3" : width_m, nullptr, false);
  if (!asked.is_number()) throw bad_input("width_m has to be a number of metres");
  const double width = machine_in({{"width_m", asked}, {"radius_m", 1}}, "").width_m;
  ordered_json out = ordered_json::array();
  for (const Operation operation : kOperations) out.push_back(usual(operation, width));
  return out;
}

}  // namespace

void add_machine_routes(Router& router, App& app) {
  router.get(api("/machines"), [&app](const Call&, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const io::ListedMachine& listed : app.machines.list()) out.push_back(json_of(listed));
    answer(response, out);
  });
  router.get(api("/operations"), [](const Call& call, httplib::Response& response) {
    answer(response, operations(call.query("width_m")));
  });
  router.post(api("/machines"), [&app](const Call& call, httplib::Response& response) {
    answer(response, json_of(app.machines.add(named_machine(call.json()))), 201);
  });
  router.put(api("/machines/{machine}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, json_of(app.machines.replace(call.part("machine"), named_machine(call.json()))));
  });
  router.remove(api("/machines/{machine}"), [&app](const Call& call, httplib::Response& response) {
    app.machines.remove(call.part("machine"));
    answer(response, {{"deleted", call.part("machine")}});
  });
}

}  // namespace tramline::server
