#pragma once
// The options for reading and evaluating a drive, common to evaluate, watch and the server.

#include <string>

#include "tramline/coverage/evaluate.h"
#include "tramline/io/log/read_log.h"

namespace tramline::app {

/// The options as typed.
struct DriveOptions {
  coverage::DriveSettings drive;
  io::LogOptions log;
  std::string quads = "heading", switching = "interpolate", repeat = "run", headings = "compass",
              engine = "exact";
  double mesh_m = coverage::EvaluateSettings{}.mesh_m;
};

/// The sides of meshes that may be asked for, m.
inline constexpr double kLeastMesh_m = 0.005, kLargestMesh_m = 1;

/// The settings these options stand for.
void apply(const DriveOptions& options, coverage::EvaluateSettings& settings);

}  // namespace tramline::app
