#pragma once
// The options by which every verb is told which field is meant.

#include "commands/verb.h"
#include "request/field_input.h"

namespace tramline::app {

/// Declares FILE, --layer, --where, --id, --all, --crs, --obstacles, --obstacle-size and --passable on the
/// verb. `options` has to outlive the parse.
void add_field_options(Verb& verb, FieldOptions& options);

/// The same with --field for FILE, which need not be given, and without --all.
void add_field_choice(Verb& verb, FieldOptions& options);

/// Only --crs, --obstacles, --obstacle-size and --passable.
void add_obstacle_options(Verb& verb, FieldOptions& options);

}  // namespace tramline::app
