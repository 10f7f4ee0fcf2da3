#pragma once
// The options that say how a drive is to be understood: what evaluate and watch have in common.

#include "options/command_options.h"
#include "request/drive_request.h"

namespace tramline::app {

/// Declares --width, --columns, --log-crs, --quads, --switch, --max-gap-s, --max-step-m, the places of
/// antenna and implement, and --repeat. `options` has to outlive the parse.
void add_drive_options(CommandOptions& command, DriveOptions& options);

}  // namespace tramline::app
