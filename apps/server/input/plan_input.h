#pragma once
// Machine, objective and settings of a plan, as the page asks for them.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "server/input/land_input.h"
#include "tramline/model/plan.h"

namespace tramline::server {

class JsonInput;

/// {name?, width_m, radius_m, min_length_m?, turning?}, turning with keys of the machine file. Throws
/// bad_input.
Machine machine_in(const nlohmann::ordered_json& json, const std::string& place);
/// {prices: {overlap, uncovered, turn, stop}} or {minimise}; none: the default prices. Throws bad_input.
Objective objective_in(const nlohmann::ordered_json& json);

struct SettingsInput {
  PlanSettings settings;
  std::vector<Point> line;  ///< to follow, longitude and latitude; empty: none
  // Where the route starts and ends, longitude and latitude.
  std::optional<Point> start{};
  std::optional<Point> end{};
  std::vector<DrawnLand> land{};
};
/// What is planned where the settings do not say: tracks alone, or a plan to be driven
/// (whole_plan_defaults()).
enum class Defaults { kTracks, kWholePlan };
/// Throws bad_input.
SettingsInput settings_in(const nlohmann::ordered_json& json, Defaults defaults);

/// The settings for a field: with line and gates in its metres. Throws bad_input where they do not lie there.
PlanSettings settings_on(const SettingsInput& input, const Field& field, const Machine& machine);

}  // namespace tramline::server
