#pragma once
// The options for reading a drive, common to evaluate and watch.

#include <string>

#include "tramline/coverage/evaluate.h"
#include "tramline/io/log/read_log.h"

namespace tramline::app {

/// The options as typed.
struct DriveOptions {
  coverage::DriveSettings drive;
  io::LogOptions log;
  std::string quads = "heading", switching = "interpolate", repeat = "run";
};

/// The settings these options stand for.
void apply(const DriveOptions& options, coverage::EvaluateSettings& settings);

}  // namespace tramline::app
