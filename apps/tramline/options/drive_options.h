#pragma once
// The options that say how a drive is to be understood: what evaluate and watch have in common.

#include "options/command_options.h"
#include "request/drive_request.h"

namespace tramline::app {

/// Declares --columns, --log-crs, --headings, --width, the places of antenna and implement, --quads,
/// --switch,
/// --max-gap-s, --max-step-m, --repeat, --engine and --mesh. `options` has to outlive the parse.
void add_drive_options(CommandOptions& command, DriveOptions& options);

}  // namespace tramline::app
