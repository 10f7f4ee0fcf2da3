#include <fmt/format.h>

#include <iterator>
#include <string>

#include "exports/export_runs.h"
#include "output/output_target.h"
#include "output/result_output.h"
#include "report/report_parts.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

constexpr double kKilobyte = 1000;

std::string table_of(const io::TaskSetReport& report, const ExportOptions& options) {
  std::string out = fmt::format("{}: ISOXML version {}, {} field{}, {:.1f} kB\n", report.file.string(),
                                options.isoxml, report.fields, report.fields == 1 ? "" : "s",
                                static_cast<double>(report.bytes) / kKilobyte);
  const auto row = [&](const char* what, std::size_t count) {
    fmt::format_to(std::back_inserter(out), "  {:<18}{:>8}\n", what, count);
  };
  row("AB lines", report.lines - report.curves);
  row("curves", report.curves);
  row("obstacles", report.obstacles);
  row("headlands", report.headlands);
  for (const io::ChangedName& name : report.changed)
    fmt::format_to(std::back_inserter(out), "renamed: '{}' is shown as '{}'\n", name.name, name.shown);
  return out;
}

ordered_json json_of(const io::TaskSetReport& report, const ExportOptions& options) {
  ordered_json renamed = ordered_json::array();
  for (const io::ChangedName& name : report.changed)
    renamed.push_back({{"name", name.name}, {"shown", name.shown}});
  return {{"plans", options.plans},
          {"fields", report.fields},
          {"tolerance_m", options.tolerance_m},
          {"file", report.file.string()},
          {"format", "ISOXML " + options.isoxml},
          {"lines", report.lines},
          {"curves", report.curves},
          {"obstacles", report.obstacles},
          {"headlands", report.headlands},
          {"bytes", report.bytes},
          {"renamed", renamed}};
}

bool is_zip(const std::string& name) { return std::filesystem::path(name).extension() == ".zip"; }

}  // namespace

void run_task_set_export(const ExportOptions& options) {
  if (is_zip(options.output))
    require_writable(options.output, "--output", {".zip"}, options.plans);
  else
    require_folder(options.output, "--output");
  io::TaskSetRequest request;
  request.plans = plan_paths(options);
  request.target = options.output;
  request.version = options.isoxml == "3" ? io::TaskDataVersion::k3 : io::TaskDataVersion::k4;
  request.lines = options.lines == "all" ? io::LineChoice::kAll : io::LineChoice::kSubfields;
  request.obstacles =
      options.obstacles == "polygons" ? io::ObstacleStyle::kPolygons : io::ObstacleStyle::kHoles;
  request.tolerance_m = options.tolerance_m;
  request.field = options.id;
  request.customer = options.customer;
  request.farm = options.farm;
  const io::TaskSetReport report = io::export_task_set(request);
  if (options.json)
    print_json(json_of(report, options));
  else if (!options.quiet)
    print_result(table_of(report, options));
}

}  // namespace tramline::app
