#pragma once
// The options for reading a drive, from a request of the page.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "request/drive_request.h"

namespace tramline::server {

/// {quads, switch, repeat, headings, engine, mesh_m, max_gap_s, max_step_m, antenna_forward_m,
/// antenna_right_m, implement_behind_m, columns, log_crs}, all of which may be missing, and the working width
/// where the log has none. Throws bad_input.
app::DriveOptions drive_options_in(const nlohmann::ordered_json& options, std::optional<double> width_m);
/// What drive_options_in() understands as the same; the width beside it.
nlohmann::ordered_json drive_options_json(const app::DriveOptions& options);

/// The settings these options stand for.
coverage::EvaluateSettings evaluate_settings(const app::DriveOptions& options);

}  // namespace tramline::server
