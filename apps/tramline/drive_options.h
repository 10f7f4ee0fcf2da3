#pragma once
// How a drive is to be understood: what evaluate and watch have in common.

#include <CLI/CLI.hpp>
#include <string>

#include "tramline/coverage/evaluate.h"
#include "tramline/io/log/read_log.h"

namespace tramline::app {

struct DriveOptions {
  coverage::DriveSettings drive;
  io::LogOptions log;
  std::string quads = "heading", switching = "interpolate", repeat = "run";
};

/// Declares --width, --columns, --log-crs, --quads, --switch, --max-gap-s, --max-step-m, the places of
/// antenna and implement, and --repeat. `options` has to outlive the parse.
void add_drive_options(CLI::App& verb, DriveOptions& options);

/// The settings these options stand for.
void apply(const DriveOptions& options, coverage::EvaluateSettings& settings);

}  // namespace tramline::app
