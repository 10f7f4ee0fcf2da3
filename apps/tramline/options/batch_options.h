#pragma once
// The options of a batch, for every face that works on one.

#include "batch/batch.h"
#include "options/command_options.h"

namespace tramline::app {

/// PARCELS, --layer, --where, --crs, the options of a plan, --output, --chunk and --resume.
void add_batch_options(CommandOptions& command, BatchRequest& request, bool& resume);
/// What is not given becomes part of a plan to be driven. To be called after parsing. Throws kBadInput.
void take_batch_defaults(const CommandOptions& command, BatchRequest& request);

}  // namespace tramline::app
