#include "options/drive_options.h"

#include <fmt/format.h>

#include <cstdlib>

namespace tramline::app {
namespace {

/// Wider than anything that drives or flies over a field, m.
constexpr double kWidest_m = 1000;

std::string sensible_width(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(value > 0 && value <= kWidest_m))
    return fmt::format("has to be more than 0 and at most {:g} m, not {}", kWidest_m, text);
  return "";
}

void add_log_options(CommandOptions& command, DriveOptions& options) {
  command.begin_group("Log");
  command
      .add_option("--columns", options.log.columns,
                  "Names of the log's columns where they are unusual: \"lon=Xcoord,lat=Ycoord,time=T\".")
      .takes("PAIRS")
      .shows_default("found by their common names");
  command
      .add_option("--log-crs", options.log.crs,
                  "Coordinate reference system of the log's x and y, such as EPSG:25832; 'none' for plain "
                  "metres.")
      .takes("CRS")
      .shows_default("degrees where they can be, else plain metres");
  command
      .add_option(
          "--headings", options.headings,
          "What headings in the log mean: 'compass', angles clockwise from north; 'math', angles "
          "anticlockwise from east; or 'from-track', nothing, so that they follow from the positions.")
      .takes("WORD")
      .one_of({"compass", "math", "from-track"})
      .shows_default();
}

void add_mounting_options(CommandOptions& command, coverage::DriveSettings& drive) {
  command.begin_group("Machine");
  command.add_option("--width", drive.width_m, "Working width in metres, where the log has none.")
      .takes("M")
      .check(sensible_width)
      .shows_default("that of the log");
  command
      .add_option("--antenna-forward", drive.antenna_forward_m,
                  "Distance of the antenna in front of the machine's middle, in metres.")
      .takes("M")
      .in_range(-100.0, 100.0)
      .shows_default();
  command
      .add_option("--antenna-right", drive.antenna_right_m,
                  "Distance of the antenna to the right of the machine's middle, in metres.")
      .takes("M")
      .in_range(-100.0, 100.0)
      .shows_default();
  command
      .add_option("--implement-behind", drive.implement_behind_m,
                  "Distance of the implement behind the machine's middle, in metres.")
      .takes("M")
      .in_range(-100.0, 100.0)
      .shows_default();
}

void add_worked_land_options(CommandOptions& command, DriveOptions& options) {
  command.begin_group("Worked land");
  command
      .add_option("--quads", options.quads,
                  "Shape of the land worked between two fixes: 'heading', whose two ends are each square to "
                  "the heading there, or 'segment', a rectangle along the line between the fixes.")
      .takes("WORD")
      .one_of({"heading", "segment"})
      .shows_default();
  command
      .add_option("--switch", options.switching,
                  "Where work and sections switch whose states differ between two fixes: 'interpolate', half "
                  "way between the fixes, or 'step', at the second fix.")
      .takes("WORD")
      .one_of({"interpolate", "step"})
      .shows_default();
  command
      .add_option("--max-gap-s", options.drive.max_gap_s,
                  "Longest time between two fixes over which land counts as worked, in seconds.")
      .takes("S")
      .positive()
      .shows_default();
  command
      .add_option("--max-step-m", options.drive.max_step_m,
                  "Longest distance between two fixes over which land counts as worked, in metres.")
      .takes("M")
      .positive()
      .shows_default();
  command
      .add_option(
          "--repeat", options.repeat,
          "Land that counts as repeated: 'run', land worked again, except what the same run had worked "
          "within the last working width of its travel, or 'strict', all land worked twice or more.")
      .takes("WORD")
      .one_of({"run", "strict"})
      .shows_default();
  const Option engine =
      command
          .add_option("--engine", options.engine,
                      "How areas are found: 'exact', or 'mesh', the algorithm of Zhang et al. 2023, which is "
                      "right to a few per mille.")
          .takes("WORD")
          .one_of({"exact", "mesh"})
          .shows_default();
  command
      .add_option("--mesh", options.mesh_m,
                  "With --engine mesh: side of one square mesh of the grid, in metres.")
      .takes("M")
      .in_range(kLeastMesh_m, kLargestMesh_m)
      .shows_default()
      .needs(engine);
}

}  // namespace

void add_drive_options(CommandOptions& command, DriveOptions& options) {
  add_log_options(command, options);
  add_mounting_options(command, options.drive);
  add_worked_land_options(command, options);
}

}  // namespace tramline::app
