#include "server/input/plan_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "request/paper_conventions.h"
#include "request/plan_defaults.h"
#include "request/plan_request.h"
#include "server/input/json_input.h"
#include "server/map/shown_place.h"
#include "tramline/geometry/error.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"
#include "tramline/planner/validate_request.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// A number of passes, or the word auto.
std::string passes_in(const JsonInput& input, const char* key) {
  if (input.value(key).is_string()) {
    if (input.text(key) != "auto")
      throw bad_input(fmt::format("{} has to be a number of passes, or \"auto\"", input.place_of(key)));
    return "auto";
  }
  const long long count = input.whole_if(key).value_or(0);
  if (count < 0 || count > 100)
    throw bad_input(fmt::format("{} has to lie between 0 and 100", input.place_of(key)));
  return std::to_string(count);
}

void take_word(const JsonInput& input, const char* key, std::string& word) {
  if (input.has(key)) word = input.text(key);
}

void take_number(const JsonInput& input, const char* key, double& number) {
  if (input.has(key)) number = input.number(key);
}

/// The keys of a route but for its gates.
/// "--obstacle-headlands" as a key: "obstacle_headlands".
std::string key_of(std::string option) {
  option.erase(0, 2);
  std::replace(option.begin(), option.end(), '-', '_');
  return option;
}

/// Makes what the request leaves out part of a plan to be driven, unless it asks for tracks alone.
void take_whole_plan(const JsonInput& input, app::PlanOptions& options) {
  if (app::asks_for_tracks(options)) return;
  for (const app::Convention& convention : app::whole_plan_defaults(options)) {
    const bool decided = input.has("line") && std::string_view(convention.option) == "--curved";
    if (!decided && !input.has(key_of(convention.option).c_str())) convention.take(options);
  }
}

void take_route(const JsonInput& input, app::PlanOptions& options) {
  if (const auto route = input.flag_if("route")) options.route = *route ? "whole" : "none";
  take_word(input, "order", options.order);
  take_word(input, "headland_time", options.headland_time);
  take_word(input, "pass_sequence", options.pass_sequence);
  take_word(input, "pass_corners", options.pass_corners);
  if (options.route != "none") return;
  for (const char* key : {"headland_time", "pass_sequence", "pass_corners", "start", "end"})
    if (input.has(key))
      throw bad_input(fmt::format("{} is for a route; set settings.route to true", input.place_of(key)));
}

std::optional<Point> gate_in(const JsonInput& input, const char* key) {
  if (!input.has(key)) return std::nullopt;
  return position_of(input.value(key), input.place_of(key));
}

std::vector<const char*> turning_keys() {
  std::vector<const char*> out{kReverseKey, kImplementKey};
  for (const TurningNumber& number : kTurningNumbers) out.push_back(number.key);
  return out;
}

Rates rates_in(const ordered_json& json, const std::string& place) {
  std::vector<const char*> keys{kOperationKey};
  for (const RateNumber& number : kRateNumbers) keys.push_back(number.key);
  const JsonInput input(json, place, keys);
  Rates out;
  if (input.has(kOperationKey)) {
    const auto operation = operation_named(input.text(kOperationKey));
    if (!operation)
      throw bad_input(
          fmt::format("{} has to be one of {}", input.place_of(kOperationKey), operation_words()));
    out.operation = *operation;
  }
  for (const RateNumber& number : kRateNumbers) {
    const std::optional<double> value = input.number_if(number.key);
    if (!value) continue;
    if (const std::string fault = fault_of(number, *value); !fault.empty())
      throw bad_input(fmt::format("{} {}", input.place_of(number.key), fault));
    out.*number.value = *value;
  }
  return out;
}

Turning turning_in(const ordered_json& json, const std::string& place, Operation operation) {
  const JsonInput input(json, place, turning_keys());
  Turning out;
  out.working_speed_mps = usual_speed_mps(operation);
  out.reverse = input.flag_if(kReverseKey).value_or(out.reverse);
  if (input.has(kImplementKey)) {
    const auto coupling = coupling_named(input.text(kImplementKey));
    if (!coupling)
      throw bad_input(fmt::format("{} has to be mounted or towed", input.place_of(kImplementKey)));
    out.implement = *coupling;
  }
  for (const TurningNumber& number : kTurningNumbers)
    out.*number.value = input.number_if(number.key).value_or(out.*number.value);
  if (const std::string fault = turning_fault(out); !fault.empty())
    throw bad_input(fmt::format("{}.{}", place, fault));
  return out;
}

/// A place on the map as the files of the field have it: longitude and latitude, or plain metres.
Point as_in_files(Point shown, const LocalFrame& frame) {
  if (frame.geodetic) return shown;
  return ShownPlace(frame).to_local(shown) + Point{frame.origin_x_m, frame.origin_y_m};
}

}  // namespace

Machine machine_in(const ordered_json& json, const std::string& place) {
  const JsonInput input(json, place,
                        {"id", "name", "width_m", "radius_m", "min_length_m", "turning", "rates"});
  app::PlanOptions options;
  options.width_m = input.number("width_m");
  options.radius_m = input.number("radius_m");
  options.min_length_m = input.number_if("min_length_m");
  Machine machine = app::machine_of(options);
  machine.name = name_of(input, "name");
  if (input.has("rates")) machine.rates = rates_in(input.value("rates"), input.place_of("rates"));
  const Operation operation = machine.rates.operation;
  machine.turning.working_speed_mps = usual_speed_mps(operation);
  if (input.has("turning"))
    machine.turning = turning_in(input.value("turning"), input.place_of("turning"), operation);
  validate_request(machine, {}, {});
  return machine;
}

Objective objective_in(const ordered_json& json) {
  if (json.is_null()) return {};
  const JsonInput input(json, "objective", {"prices", "minimise"});
  if (input.has("prices") == input.has("minimise"))
    throw bad_input("objective has to have either prices or minimise");
  if (input.has("minimise")) {
    app::PlanOptions options;
    options.minimise = input.text("minimise");
    return app::objective_of(options);
  }
  const JsonInput prices(input.value("prices"), "objective.prices",
                         {"overlap", "uncovered", "turn", "stop", "subfield"});
  return {prices.number("overlap"), prices.number("uncovered"), prices.number("turn"),
          prices.number_if("stop").value_or(Objective{}.stop),
          prices.number_if("subfield").value_or(Objective{}.subfield)};
}

namespace {

constexpr std::array kSettingsKeys = {"like",          "strategy",
                                      "end_rule",      "boundary",
                                      "headlands",     "obstacle_headlands",
                                      "curved",        "line",
                                      "avoid",         "avoid_threshold_m",
                                      "avoid_room_m",  "clearance_m",
                                      "merge_deg",     "decomposition_deg",
                                      "short_edge_m",  "direction_tolerance_deg",
                                      "prove",         "cell_direction",
                                      "tracks",        "ab_anchor",
                                      "turns",         "spacing",
                                      "turn_room_m",   "towing_error_m",
                                      "route",         "order",
                                      "headland_time", "pass_sequence",
                                      "pass_corners",  "start",
                                      "end",           "land"};

}  // namespace

SettingsInput settings_in(const ordered_json& asked, Defaults defaults) {
  const ordered_json json = asked.is_null() ? ordered_json::object() : asked;
  const JsonInput input(json, "settings", kSettingsKeys);
  app::PlanOptions options;
  options.turns = input.flag_if("turns").value_or(false);
  take_word(input, "like", options.like);
  for (const app::Convention& convention : app::conventions_like(options.like)) convention.take(options);
  take_word(input, "strategy", options.strategy);
  take_word(input, "tracks", options.tracks);
  if (defaults == Defaults::kWholePlan) take_whole_plan(input, options);
  take_word(input, "end_rule", options.end_rule);
  take_word(input, "boundary", options.boundary);
  take_word(input, "cell_direction", options.cell_direction);
  take_word(input, "curved", options.curved);
  take_word(input, "avoid", options.avoid);
  take_word(input, "ab_anchor", options.ab_anchor);
  take_number(input, "clearance_m", options.clearance_m);
  take_number(input, "merge_deg", options.merge_deg);
  take_number(input, "decomposition_deg", options.decomposition_deg);
  take_number(input, "short_edge_m", options.short_edge_m);
  take_number(input, "direction_tolerance_deg", options.direction_tolerance_deg);
  options.prove = input.flag_if("prove").value_or(false);
  take_word(input, "spacing", options.spacing);
  take_number(input, "towing_error_m", options.towing_error_m);
  options.turn_room_m = input.number_if("turn_room_m");
  take_route(input, options);
  options.avoid_threshold_m = input.number_if("avoid_threshold_m");
  options.avoid_room_m = input.number_if("avoid_room_m");
  if (input.has("headlands")) options.headlands = passes_in(input, "headlands");
  if (input.has("obstacle_headlands"))
    options.obstacle_headlands = passes_in(input, "obstacle_headlands");
  else if (options.like == "zhou")
    options.obstacle_headlands = options.headlands;
  SettingsInput out{app::settings_of(options), {}, gate_in(input, "start"), gate_in(input, "end")};
  if (input.has("land")) out.land = land_in(input.value("land"), input.place_of("land"));
  if (!input.has("line")) return out;
  if (input.has("curved")) throw bad_input("settings has both curved and a line to follow; give one of them");
  out.line = positions_of(input.value("line"), input.place_of("line"));
  return out;
}

PlanSettings settings_on(const SettingsInput& input, const Field& field, const Machine& machine) {
  PlanSettings out = input.settings;
  if (!input.land.empty()) out.given = land_on(input.land, field);
  if (!input.line.empty()) {
    GuideLine guide{"the line that was drawn", {}, !field.frame.geodetic};
    for (const Point p : input.line) guide.points.push_back(as_in_files(p, field.frame));
    out = app::settings_for(out, guide, field, machine);
  }
  const auto gate = [&](const std::optional<Point>& at, const char* what) -> std::optional<GatePoints> {
    if (!at) return std::nullopt;
    return GatePoints{what, {as_in_files(*at, field.frame)}, !field.frame.geodetic};
  };
  app::place_gates({gate(input.start, "the start of the route"), gate(input.end, "the end of the route")},
                   field, out);
  return out;
}

}  // namespace tramline::server
