// Any bytes as the body of a request to the server, taken in by its router: machines, objectives, settings,
// shapes that were drawn, how a drive is to be read, and changes of a field.
//
// The first byte picks the address, the rest is the body.

#include <httplib.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "server/http/router.h"
#include "server/input/drive_input.h"
#include "server/input/field_change.h"
#include "server/input/field_source.h"
#include "server/input/json_input.h"
#include "server/input/plan_input.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/planner/validate_request.h"

namespace {

using namespace tramline;
using namespace tramline::server;
using nlohmann::ordered_json;

void demand(bool holds) {
  if (!holds) std::abort();
}

Field small_field() {
  Field field;
  field.id = "small";
  field.outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  field.frame = {true, 9, 54, 0, 0};
  Obstacle pond;
  pond.shape.outer = {{100, 100}, {120, 100}, {120, 120}};
  pond.origin = "pond";
  field.obstacles.push_back(pond);
  return field;
}

void plan(const ordered_json& json) {
  const JsonInput input(json, "", {"machine", "objective", "settings", "name"});
  name_of(input, "name");
  const Machine machine = machine_in(input.value("machine"), "machine");
  demand(machine.width_m > 0 && std::isfinite(machine.width_m) && std::isfinite(machine.radius_m));
  const Objective objective = objective_in(input.value("objective"));
  const SettingsInput settings = settings_in(input.value("settings"), Defaults::kWholePlan);
  validate_request(machine, objective, settings.settings);
  const PlanSettings placed = settings_on(settings, small_field(), machine);
  for (const std::optional<Point>& gate : {placed.route.start, placed.route.end})
    demand(!gate || (std::isfinite(gate->x) && std::isfinite(gate->y)));
}

void draw(const ordered_json& json) {
  const JsonInput input(json, "", {"geometry", "name"});
  const NewFields drawn = fields_drawn(input.value("geometry"), name_of(input, "name"));
  demand(!drawn.fields.empty());
  for (const Field& field : drawn.fields) demand(std::isfinite(area_m2(field)));
}

void change(const ordered_json& json) {
  const JsonInput input(json, "", {"add", "remove"});
  const Field changed = changed_field(small_field(), input.list("remove"), input.list("add"));
  for (const Obstacle& obstacle : changed.obstacles) demand(std::isfinite(area(obstacle.shape)));
}

void drive(const ordered_json& json) {
  const JsonInput input(json, "", {"options", "width_m"});
  drive_options_json(drive_options_in(input.value("options"), input.number_if("width_m")));
}

const Router& router() {
  static Router out;
  if (!out.routes().empty()) return out;
  const auto add = [](const char* where, void (*take)(const ordered_json&)) {
    out.post(where, [take](const Call& call, httplib::Response& response) {
      call.query_number("from_s");
      take(call.json());
      answer(response, {{"taken", true}});
    });
  };
  add("/plan/{part}", plan);
  add("/draw", draw);
  add("/change", change);
  add("/drive", drive);
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kPaths = {"/plan/one", "/draw", "/change", "/drive"};
  if (size == 0) return 0;
  const std::string body(reinterpret_cast<const char*>(data) + 1, size - 1);
  httplib::Request request;
  request.method = "POST";
  request.path = kPaths[data[0] % kPaths.size()];
  // The same bytes as what stands in the address.
  request.params.emplace("from_s", body.substr(0, body.find('{')));
  request.set_header("Content-Length", std::to_string(body.size()));
  const httplib::ContentReader reader(
      [&body](httplib::ContentReceiver take) { return take(body.data(), body.size()); },
      [](httplib::MultipartContentHeader, httplib::ContentReceiver) { return false; });
  httplib::Response response;
  router().serve(request, response, &reader);
  // What went wrong within the program, and a refusal without a sentence, are faults.
  demand(response.status == 200 || response.status == 400);
  demand(ordered_json::accept(response.body));
  return 0;
}
