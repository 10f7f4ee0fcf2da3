#pragma once
// The options that say which field a command works on.

#include "options/command_options.h"
#include "request/field_input.h"

namespace tramline::app {

/// Declares FILE, --layer, --where, --id, --all, --crs, --obstacles, --obstacle-size and --passable on the
/// command. `options` has to outlive the parse.
void add_field_options(CommandOptions& command, FieldOptions& options);

/// The same, but with an optional --field in place of FILE, and without --all.
void add_field_choice(CommandOptions& command, FieldOptions& options);

/// Only --crs.
void add_crs_option(CommandOptions& command, FieldOptions& options);

/// Only --obstacles, --obstacle-size and --passable.
void add_obstacle_options(CommandOptions& command, FieldOptions& options);

}  // namespace tramline::app
