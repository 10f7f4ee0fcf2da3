#include "tables/map_table_run.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "report/map_table_report.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

MapDirections directions_of(const MapTableTask& task) {
  if (task.directions) return map_directions(*task.directions, task.field, task.settings.merge_threshold);
  return {{MapDirection{}}, 0};
}

render::SmallMap small_map(const MapCell& cell, Plan plan, bool same_width) {
  const std::string what = map_direction_text(cell.asked),
                    width = fmt::format("{:g} m", cell.machine.width_m);
  const Tally& tally = cell.tracks;
  return {std::move(plan),
          same_width ? what : width,
          {fmt::format("{} tracks, {:.0f} m, {} turns", tally.pieces, tally.track_length_m, tally.turns),
           fmt::format("overlap {:.0f} m², uncovered {:.0f} m²", std::abs(tally.overlap_m2),
                       std::abs(tally.uncovered_m2))}};
}

}  // namespace

void add_map_table_options(CommandOptions& command, MapTableOptions& o) {
  command.begin_group("Comparison");
  command
      .add_option(
          "--directions", o.directions,
          "Print a table of maps in these directions: 'edges' (of the field, longest first; those that "
          "differ by no more than 5°, or --merge where that is more, are one), degrees clockwise from north, "
          "and 'curved' (along an edge), separated by commas. Straight tracks begin at the edge of the land "
          "unless --ab-anchor "
          "says line.")
      .takes("LIST")
      .shows_default("one map");
  command
      .add_option("--widths", o.widths,
                  "Print a table of maps at these working widths, in metres, separated by commas.")
      .takes("LIST")
      .shows_default("--width");
  command.add_option("--table", o.table_file, "Write the table to this .csv.")
      .takes("FILE")
      .shows_default("not written");
}

MapTableResult mapped(const MapTableTask& task, const MapPlanner& plan) {
  const MapDirections directions = directions_of(task);
  std::vector<PlanSettings> settings;
  for (const MapDirection& direction : directions.all)
    settings.push_back(settings_in_direction(task.settings, direction));
  const bool same_width = directions.all.size() > 1;
  MapTableResult out{{task.field, task.widths_m, directions.edges_left_out, {}}};
  std::optional<Error> first_refusal;
  bool any = false;
  for (std::size_t i = 0; i < directions.all.size(); ++i)
    for (std::size_t k = 0; k < task.widths_m.size(); ++k) {
      Machine machine = task.machine;
      machine.width_m = task.widths_m[k];
      try {
        const auto start = std::chrono::steady_clock::now();
        Plan found = plan(machine, settings[i]);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        out.table.cells.push_back(map_cell(directions.all[i], found, elapsed.count()));
        any = true;
        if (k == 0 || !same_width)
          out.shown.push_back(small_map(out.table.cells.back(), std::move(found), same_width));
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput) throw;
        if (!first_refusal) first_refusal = error;
        MapCell cell{directions.all[i], machine, {}};
        cell.refusal = error.what();
        out.table.cells.push_back(std::move(cell));
      }
    }
  if (!any && first_refusal) throw Error(*first_refusal);
  return out;
}

}  // namespace tramline::app
