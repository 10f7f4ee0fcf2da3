#include <fmt/format.h>

#include <iterator>
#include <string>

#include "exports/export_runs.h"
#include "output/output_target.h"
#include "output/result_output.h"
#include "report/report_parts.h"
#include "tramline/geometry/error.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

std::string field_of(const io::ExportReport& report) {
  return report.fields == 1 ? "field " + report.field_id : fmt::format("{} fields", report.fields);
}

std::string table_of(const io::ExportReport& report, const std::string& output) {
  std::string out =
      fmt::format("{}: {}, {}, {}\n", output, field_of(report), name(report.format), report.crs);
  for (const io::ExportedLayer& layer : report.layers)
    fmt::format_to(std::back_inserter(out), "  {:<18}{:>8}\n", layer.name, layer.features);
  for (const Skipped& text : report.shortened)
    fmt::format_to(std::back_inserter(out), "shortened: {} ({}): {}\n", text.what, text.where, text.why);
  return out;
}

ordered_json json_of(const io::ExportReport& report, const ExportOptions& options) {
  ordered_json layers = ordered_json::array();
  for (const io::ExportedLayer& layer : report.layers)
    layers.push_back({{"name", layer.name}, {"features", layer.features}});
  return {{"plan", options.plans.front()},
          {"field_id", report.fields == 1 ? ordered_json(report.field_id) : ordered_json()},
          {"fields", report.fields},
          {"tolerance_m", options.tolerance_m},
          {"file", options.output},
          {"format", name(report.format)},
          {"crs", report.crs},
          {"layers", layers},
          {"shortened", skipped_json(report.shortened)}};
}

}  // namespace

void run_layer_export(const ExportOptions& options) {
  // Those of routes and cards, too: the message is to name all that there are.
  require_writable(
      options.output, "--output",
      {".geojson", ".fgb", ".kml", ".zip", ".gpx", ".plan", ".waypoints", ".kmz", ".yaml", ".json", ".pdf"},
      options.plans);
  if (options.plans.size() > 1)
    throw bad_input(
        fmt::format("layers are exported from one plan file, not from {}; export them one by one, or plan "
                    "all fields into one "
                    "file with --one-file",
                    options.plans.size()));
  const io::ExportReport report = io::export_plan(
      {options.plans.front(), options.output, options.crs, options.layers, options.tolerance_m, options.id});
  if (options.json)
    print_json(json_of(report, options));
  else if (!options.quiet)
    print_result(table_of(report, options.output));
}

}  // namespace tramline::app
