#include "server/input/drive_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "server/input/json_input.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// Wider than anything that drives or flies over a field, m.
constexpr double kWidest_m = 1000;
/// Further than an antenna or an implement is from the middle of a machine, m.
constexpr double kFarthestPart_m = 100;

void take_word(const JsonInput& input, const char* key, const std::vector<std::string>& known,
               std::string& out) {
  if (!input.has(key)) return;
  out = input.text(key);
  if (std::find(known.begin(), known.end(), out) == known.end())
    throw bad_input(
        fmt::format("{} has to be {}, not '{}'", input.place_of(key), fmt::join(known, " or "), out));
}

void take_positive(const JsonInput& input, const char* key, double& out) {
  const auto value = input.number_if(key);
  if (!value) return;
  if (!(*value > 0))
    throw bad_input(fmt::format("{} has to be more than 0, not {}", input.place_of(key), *value));
  out = *value;
}

void take_mesh(const JsonInput& input, double& out) {
  const auto value = input.number_if("mesh_m");
  if (!value) return;
  if (!(*value >= app::kLeastMesh_m && *value <= app::kLargestMesh_m))
    throw bad_input(fmt::format("{} has to be between {:g} and {:g} m, not {}", input.place_of("mesh_m"),
                                app::kLeastMesh_m, app::kLargestMesh_m, *value));
  out = *value;
}

void take_offset(const JsonInput& input, const char* key, double& out) {
  const auto value = input.number_if(key);
  if (!value) return;
  if (!(std::abs(*value) <= kFarthestPart_m))
    throw bad_input(fmt::format("{} has to be between {:g} and {:g} m, not {}", input.place_of(key),
                                -kFarthestPart_m, kFarthestPart_m, *value));
  out = *value;
}

}  // namespace

app::DriveOptions drive_options_in(const ordered_json& options, std::optional<double> width_m) {
  app::DriveOptions out;
  if (width_m && !(*width_m > 0 && *width_m <= kWidest_m))
    throw bad_input(
        fmt::format("width_m has to be more than 0 and at most {:g} m, not {}", kWidest_m, *width_m));
  if (width_m) out.drive.width_m = *width_m;
  if (options.is_null()) return out;
  const JsonInput input(
      options, "options",
      {"quads", "switch", "repeat", "headings", "engine", "mesh_m", "max_gap_s", "max_step_m",
       "antenna_forward_m", "antenna_right_m", "implement_behind_m", "columns", "log_crs"});
  take_word(input, "quads", {"heading", "segment"}, out.quads);
  take_word(input, "switch", {"interpolate", "step"}, out.switching);
  take_word(input, "repeat", {"run", "strict"}, out.repeat);
  take_word(input, "headings", {"compass", "math", "from-track"}, out.headings);
  take_word(input, "engine", {"exact", "mesh"}, out.engine);
  take_mesh(input, out.mesh_m);
  take_positive(input, "max_gap_s", out.drive.max_gap_s);
  take_positive(input, "max_step_m", out.drive.max_step_m);
  take_offset(input, "antenna_forward_m", out.drive.antenna_forward_m);
  take_offset(input, "antenna_right_m", out.drive.antenna_right_m);
  take_offset(input, "implement_behind_m", out.drive.implement_behind_m);
  out.log.columns = input.text_or_none("columns");
  out.log.crs = input.text_or_none("log_crs");
  return out;
}

ordered_json drive_options_json(const app::DriveOptions& options) {
  const coverage::DriveSettings& drive = options.drive;
  return {{"quads", options.quads},
          {"switch", options.switching},
          {"repeat", options.repeat},
          {"headings", options.headings},
          {"engine", options.engine},
          {"mesh_m", options.mesh_m},
          {"max_gap_s", drive.max_gap_s},
          {"max_step_m", drive.max_step_m},
          {"antenna_forward_m", drive.antenna_forward_m},
          {"antenna_right_m", drive.antenna_right_m},
          {"implement_behind_m", drive.implement_behind_m},
          {"columns", options.log.columns},
          {"log_crs", options.log.crs}};
}

coverage::EvaluateSettings evaluate_settings(const app::DriveOptions& options) {
  coverage::EvaluateSettings out;
  app::apply(options, out);
  return out;
}

}  // namespace tramline::server
