#pragma once
// The kinds of jobs of POST /jobs. Each reads the whole request before it begins anything, and throws
// bad_input or HttpError(kNotFound) where something is wrong with it.

#include <nlohmann/json_fwd.hpp>

#include "server/app.h"
#include "server/jobs/job.h"

namespace tramline::server {

JobStatus begin_plan(App& app, const nlohmann::ordered_json& json);
/// A new drive from an upload.
JobStatus begin_drive(App& app, const nlohmann::ordered_json& json);
/// A drive that is kept, evaluated anew.
JobStatus begin_evaluate(App& app, const nlohmann::ordered_json& json);
JobStatus begin_repair(App& app, const nlohmann::ordered_json& json);
JobStatus begin_compare(App& app, const nlohmann::ordered_json& json);
JobStatus begin_check(App& app, const nlohmann::ordered_json& json);

/// At the start: drives that a server was just replacing when it was killed are evaluated anew.
void finish_half_replaced(App& app);

}  // namespace tramline::server
