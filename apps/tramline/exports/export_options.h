#pragma once
// What a user asks of 'tramline export'.

#include <string>
#include <vector>

#include "tramline/io/export/export_plan.h"

namespace tramline::app {

struct ExportOptions {
  std::vector<std::string> plans;
  std::string output;
  // Layers for programs.
  std::string crs;
  std::vector<std::string> layers;
  double tolerance_m = io::ExportRequest{}.tolerance_m;
  std::string id;
  // Guidance terminals.
  std::string isoxml;  ///< "4", "3"; empty: no task set
  bool agopengps = false;
  std::string lines = "subfield";
  std::string obstacles = "holes";
  std::string customer = io::TaskSetRequest{}.customer, farm = io::TaskSetRequest{}.farm;

  // Routes.
  std::string machine;  ///< a machine file that says how a drone flies

  bool json = false, quiet = false;
};

io::LineChoice line_choice(const ExportOptions& options);

/// The same plan files as paths.
std::vector<std::filesystem::path> plan_paths(const ExportOptions& options);

}  // namespace tramline::app
