// tramline export: the layers of a plan for other programs.

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

#include "commands/command.h"
#include "output/output_target.h"
#include "output/result_output.h"
#include "report/report_parts.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kAbout =
    "Export a plan to GeoJSON, FlatGeobuf, KML or zipped Shapefiles, for guidance terminals and other "
    "programs that do not read GeoPackages";

constexpr const char* kExample =
    "Example:\n"
    "  tramline export plan.gpkg -o tracks.geojson\n"
    "  tramline export plan.gpkg -o plan.zip --crs EPSG:25832\n"
    "  tramline export plans.gpkg -o tracks.kml --id mill-field --tolerance 0.1\n"
    "  tramline export plan.gpkg -o uncovered.fgb --layer uncovered --crs wgs84\n"
    "GeoJSON and KML are always in WGS 84; the others are in the coordinate reference system of the file "
    "the\n"
    "field was read from. Shapefiles hold every layer that has shapes, the others the tracks alone.";

class ExportCommand : public Command {
 public:
  Verb setup(CLI::App& program) override {
    Verb verb(program, "export", kAbout);
    verb.add_option("PLAN", plan_file_, "the plan: a GeoPackage written by tramline plan").required();
    verb.add_option("-o,--output", output_,
                    "write to this file: .geojson, .fgb (FlatGeobuf), .kml or .zip (Shapefiles)")
        .required();
    verb.add_option("--crs", crs_,
                    "coordinates of the output: 'source' (those of the field's file), 'wgs84', or a "
                    "coordinate reference system such as EPSG:25832");
    verb.add_option("--layer", layers_,
                    "export this layer of the plan; may be given again and again for .zip and .kml")
        .one_value_each_time();
    verb.add_option("--tolerance", tolerance_m_,
                    "how far lines and outlines may run beside the plan's to need fewer points, m; 0 keeps "
                    "all points")
        .shows_default();
    verb.add_option("--id", id_,
                    "of a file of many plans (plan --one-file): only that of the field of this id or key "
                    "(default all)");
    add_unused_threads_option(verb, threads_);
    verb.add_flag("--json", json_, "print one JSON object instead of the table");
    verb.add_flag("--quiet", quiet_, "no table");
    verb.footer(kExample);
    return verb;
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
