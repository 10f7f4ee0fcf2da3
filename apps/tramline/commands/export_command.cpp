// tramline export: plans for other programs, and for the machine.

#include <filesystem>
#include <string>

#include "commands/command.h"
#include "exports/export_options.h"
#include "exports/export_runs.h"
#include "options/common_options.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kExportAbout =
    "Export plans: to GeoJSON, FlatGeobuf, KML or zipped Shapefiles for other programs, to ISOXML and "
    "AgOpenGPS for "
    "guidance terminals, and routes for autopilots, robots and drones.";

constexpr const char* kExportExample =
    "Examples:\n"
    "  tramline export plan.gpkg -o tracks.geojson\n"
    "  tramline export plan.gpkg -o plan.zip --crs EPSG:25832\n"
    "  tramline export plans.gpkg -o tracks.kml --id mill-field --tolerance 0.1\n"
    "  tramline export plan.gpkg -o uncovered.fgb --layer uncovered --crs wgs84\n"
    "  tramline export north.gpkg south.gpkg -o /media/card --isoxml 4\n"
    "  tramline export plan.gpkg -o Fields/Mill --agopengps --lines all\n"
    "  tramline export plan.gpkg -o mission.plan --machine drone.toml\n"
    "  tramline export plan.gpkg -o route.yaml\n"
    "  tramline export plan.gpkg -o card.pdf\n"
    "GeoJSON and KML are always in WGS 84.";

class ExportCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "export", kExportAbout);
    command
        .add_option("PLAN", options_.plans,
                    "The plan: a GeoPackage written by 'tramline plan' or 'tramline repair', or the coverage "
                    "of 'tramline evaluate'. Terminals and "
                    "cards take several.")
        .required();
    command.begin_group("Output");
    command
        .add_option(
            "-o,--output", options_.output,
            "Write to this file: .geojson, .fgb (FlatGeobuf), .kml or .zip (Shapefiles); the route: .gpx, "
            ".plan "
            "(QGroundControl), .waypoints, .kmz (DJI), .yaml or .json (robots); a card to print: .pdf; with "
            "--isoxml or --agopengps a .zip or a folder.")
        .takes("FILE")
        .required();
    command
        .add_option(
            "--tolerance", options_.tolerance_m,
            "Largest distance between exported lines and outlines and those of the plan, in metres; 0 "
            "keeps all points.")
        .takes("M")
        .shows_default();
    command
        .add_option(
            "--id", options_.id,
            "Of a file of many plans ('tramline plan --one-file'): export only that of the field of this "
            "id or key.")
        .takes("ID")
        .shows_default("all plans");
    command.add_flag("--json", options_.json, "Print one JSON object instead of the table.");
    command.add_flag("--quiet", options_.quiet, "Print no table.");
    add_layer_options(command);
    add_terminal_options(command);
    add_route_options(command);
    command.begin_group("Run");
    add_unused_threads_option(command, threads_);
    command.footer(kExportExample);
    return command;
  }

  int run() override {
    require_terminal_format();
    require_route_format();
    if (!options_.isoxml.empty())
      run_task_set_export(options_);
    else if (options_.agopengps)
      run_agopengps_export(options_);
    else if (is_line_card())
      run_line_card_export(options_);
    else if (const auto format = io::route_format_of(options_.output))
      run_route_export(options_, *format);
    else
      run_layer_export(options_);
    return 0;
  }

 private:
  /// What only terminals are told is not ignored in silence elsewhere.
  void require_terminal_format() const {
    if (options_.lines != ExportOptions{}.lines && options_.isoxml.empty() && !options_.agopengps)
      throw bad_input("--lines is for terminals; give --isoxml or --agopengps too, or leave it out");
  }

  bool is_line_card() const {
    const std::string extension = std::filesystem::path(options_.output).extension().string();
    return extension == ".pdf" || extension == ".PDF";
  }

  void require_route_format() const {
    const auto format = io::route_format_of(options_.output);
    const bool terminal = !options_.isoxml.empty() || options_.agopengps;
    const bool is_mission = format == io::RouteFormat::kQgcPlan || format == io::RouteFormat::kQgcWaypoints ||
                            format == io::RouteFormat::kDji;
    if (!options_.machine.empty() && (!is_mission || terminal))
      throw bad_input(
          "--machine is for missions; name a .plan, .waypoints or .kmz file with it, or leave it out");
    if ((format || is_line_card()) && !terminal && (!options_.crs.empty() || !options_.layers.empty()))
      throw bad_input("--crs and --layer are for layers, and this is another kind of file; leave them out");
  }

  void add_layer_options(CommandOptions& command) {
    command.begin_group("Layers for other programs");
    command
        .add_option(
            "--crs", options_.crs,
            "Coordinates of the output: 'source' (those of the field's file), 'wgs84', or a coordinate "
            "reference system such as EPSG:25832.")
        .takes("CRS")
        .shows_default("wgs84 for GeoJSON and KML, else source");
    command
        .add_option("--layer", options_.layers,
                    "Export this layer of the plan. May be given several times for .zip and .kml.")
        .takes("NAME")
        .one_value_each_time()
        .shows_default("every layer with shapes for .zip, else tracks and headland passes");
  }

  void add_terminal_options(CommandOptions& command) {
    command.begin_group("Guidance terminals");
    const Option isoxml =
        command
            .add_option("--isoxml", options_.isoxml,
                        "Write an ISOXML task set of this version, 4 or 3, with all plans in it. A "
                        "folder gets TASKDATA/TASKDATA.XML.")
            .takes("VERSION")
            .one_of({"4", "3"})
            .shows_default("no task set")
            .excludes(command.option("--crs"))
            .excludes(command.option("--layer"));
    command
        .add_flag("--agopengps", options_.agopengps,
                  "Write the field folder of AgOpenGPS, of several plans a folder with one for each.")
        .excludes(isoxml)
        .excludes(command.option("--crs"))
        .excludes(command.option("--layer"));
    command
        .add_option(
            "--lines", options_.lines,
            "Guidance lines: 'subfield', an AB line or curve for each subfield, to which the terminal makes "
            "parallels; 'all', every track and headland pass.")
        .takes("CHOICE")
        .one_of({"subfield", "all"})
        .shows_default();
    command
        .add_option(
            "--isoxml-obstacles", options_.obstacles,
            "Obstacles as 'holes' in the boundary, or as 'polygons' of their own: terminals take one or the "
            "other.")
        .takes("STYLE")
        .one_of({"holes", "polygons"})
        .needs(isoxml)
        .shows_default();
    command.add_option("--customer", options_.customer, "Customer of the task set.")
        .takes("NAME")
        .needs(isoxml)
        .shows_default();
    command.add_option("--farm", options_.farm, "Farm of the task set.")
        .takes("NAME")
        .needs(isoxml)
        .shows_default();
  }

  void add_route_options(CommandOptions& command) {
    command.begin_group("Routes");
    command
        .add_option("--machine", options_.machine,
                    "How a drone flies: a machine file with flight_altitude_m. For .plan, .waypoints and "
                    ".kmz; without it "
                    "the mission is one on the ground.")
        .takes("FILE")
        .shows_default("on the ground");
  }

  ExportOptions options_;
  int threads_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace tramline::app
