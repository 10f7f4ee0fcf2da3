#pragma once
// A log that is kept, read and evaluated.

#include <filesystem>

#include "request/evaluate_input.h"
#include "server/store/drive_store.h"
#include "tramline/coverage/evaluate.h"

namespace tramline::server {

/// The log under its user's name, which messages are about, too. Throws kBadInput.
WorkLog read_work_log(const std::filesystem::path& path, const DriveSource& source);

/// As `tramline evaluate` does. `ground`: empty without a field. Throws kBadInput.
Coverage evaluated_log(WorkLog read, app::WorkGround ground, const coverage::EvaluateSettings& settings,
                       const coverage::FixProgress& progress);

}  // namespace tramline::server
