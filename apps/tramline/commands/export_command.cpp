// tramline export: the layers of a plan for other programs.

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

#include "commands/command.h"
#include "options/common_options.h"
#include "output/output_target.h"
#include "output/result_output.h"
#include "report/report_parts.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kAbout =
    "Export a plan to GeoJSON, FlatGeobuf, KML or zipped Shapefiles, for guidance terminals and other "
    "programs that do not read GeoPackages.";

constexpr const char* kExample =
    "Examples:\n"
    "  tramline export plan.gpkg -o tracks.geojson\n"
    "  tramline export plan.gpkg -o plan.zip --crs EPSG:25832\n"
    "  tramline export plans.gpkg -o tracks.kml --id mill-field --tolerance 0.1\n"
    "  tramline export plan.gpkg -o uncovered.fgb --layer uncovered --crs wgs84\n"
    "GeoJSON and KML are always in WGS 84.";

class ExportCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "export", kAbout);
    command.add_option("PLAN", plan_file_, "The plan: a GeoPackage written by 'tramline plan'.").required();
    command.begin_group("Output");
    command
        .add_option("-o,--output", output_,
                    "Write to this file: .geojson, .fgb (FlatGeobuf), .kml or .zip (Shapefiles).")
        .takes("FILE")
        .required();
    command
        .add_option(
            "--crs", crs_,
            "Coordinates of the output: 'source' (those of the field's file), 'wgs84', or a coordinate "
            "reference system such as EPSG:25832.")
        .takes("CRS")
        .shows_default("wgs84 for GeoJSON and KML, else source");
    command
        .add_option("--layer", layers_,
                    "Export this layer of the plan. May be given several times for .zip and .kml.")
        .takes("NAME")
        .one_value_each_time()
        .shows_default("every layer with shapes for .zip, else tracks and headland passes");
    command
        .add_option(
            "--tolerance", tolerance_m_,
            "Largest distance between exported lines and outlines and those of the plan, in metres; 0 "
            "keeps all points.")
        .takes("M")
        .shows_default();
    command
        .add_option(
            "--id", id_,
            "Of a file of many plans ('tramline plan --one-file'): export only that of the field of this "
            "id or key.")
        .takes("ID")
        .shows_default("all plans");
    command.add_flag("--json", json_, "Print one JSON object instead of the table.");
    command.add_flag("--quiet", quiet_, "Print no table.");
    command.begin_group("Run");
    add_unused_threads_option(command, threads_);
    command.footer(kExample);
    return command;
  }

  int run() override {
    require_writable(output_, "--output", {".geojson", ".fgb", ".kml", ".zip"}, {plan_file_});
    const io::ExportReport report = io::export_plan({plan_file_, output_, crs_, layers_, tolerance_m_, id_});
    if (json_)
      print_json(json_of(report));
    else if (!quiet_)
      print_result(table_of(report));
    return 0;
  }

 private:
  std::string table_of(const io::ExportReport& report) const {
    std::string out =
        fmt::format("{}: {}, {}, {}\n", output_, field_of(report), name(report.format), report.crs);
    for (const io::ExportedLayer& layer : report.layers)
      fmt::format_to(std::back_inserter(out), "  {:<18}{:>8}\n", layer.name, layer.features);
    for (const Skipped& text : report.shortened)
      fmt::format_to(std::back_inserter(out), "shortened: {} ({}): {}\n", text.what, text.where, text.why);
    return out;
  }

  static std::string field_of(const io::ExportReport& report) {
    return report.fields == 1 ? "field " + report.field_id : fmt::format("{} fields", report.fields);
  }

  nlohmann::ordered_json json_of(const io::ExportReport& report) const {
    nlohmann::ordered_json layers = nlohmann::ordered_json::array();
    for (const io::ExportedLayer& layer : report.layers)
      layers.push_back({{"name", layer.name}, {"features", layer.features}});
    return {
        {"plan", plan_file_},
        {"field_id", report.fields == 1 ? nlohmann::ordered_json(report.field_id) : nlohmann::ordered_json()},
        {"fields", report.fields},
        {"tolerance_m", tolerance_m_},
        {"file", output_},
        {"format", name(report.format)},
        {"crs", report.crs},
        {"layers", layers},
        {"shortened", skipped_json(report.shortened)}};
  }

  std::string plan_file_, output_, crs_, id_;
  double tolerance_m_ = io::ExportRequest{}.tolerance_m;
  std::vector<std::string> layers_;
  int threads_ = 0;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace tramline::app
