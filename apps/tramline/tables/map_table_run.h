#pragma once
// The run of `map --directions` and `map --widths`: a map for each direction at each width.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "options/command_options.h"
#include "request/map_table.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {

/// The options as typed; empty where the user gave none.
struct MapTableOptions {
  std::string directions, widths, table_file;
  bool asked() const { return !directions.empty() || !widths.empty(); }
};

void add_map_table_options(CommandOptions& command, MapTableOptions& options);

/// What is to be mapped.
struct MapTableTask {
  Field field;
  Machine machine;        ///< its width where no widths were typed
  PlanSettings settings;  ///< with the guide, if any
  std::optional<DirectionWords> directions{};
  std::vector<double> widths_m;
};

/// The plan of a field with this machine and these settings.
using MapPlanner = std::function<Plan(const Machine& machine, const PlanSettings& settings)>;

/// A table, and of its maps those that a picture shows: all directions at the first width, or the one
/// direction at all widths.
struct MapTableResult {
  MapTable table;
  std::vector<render::SmallMap> shown{};
};

/// Calls `plan` once for each cell, one after the other. A cell whose map is refused has the reason. Throws
/// the first refusal where all are refused, and kBadInput for directions that cannot be as the settings say.
MapTableResult mapped(const MapTableTask& task, const MapPlanner& plan);

}  // namespace tramline::app
