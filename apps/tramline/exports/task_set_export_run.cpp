#include <fmt/format.h>

#include <string>

#include "exports/export_parts.h"
#include "exports/export_runs.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

constexpr double kKilobyte = 1000;

std::string table_of(const io::TaskSetReport& report, const ExportOptions& options) {
  std::string out = fmt::format("{}: ISOXML version {}, {} field{}, {:.1f} kB\n", report.file.string(),
                                options.isoxml, report.fields, report.fields == 1 ? "" : "s",
                                static_cast<double>(report.bytes) / kKilobyte);
  out += count_row("AB lines", report.lines - report.curves) + count_row("curves", report.curves) +
         count_row("obstacles", report.obstacles) + count_row("headlands", report.headlands);
  if (report.gaps > 0) out += count_row("gaps", report.gaps);
  return out + renamed_rows(report.changed);
}

ordered_json json_of(const io::TaskSetReport& report, const ExportOptions& options) {
  return {{"plans", options.plans},
          {"fields", report.fields},
          {"tolerance_m", options.tolerance_m},
          {"file", report.file.string()},
          {"format", "ISOXML " + options.isoxml},
          {"lines", report.lines},
          {"curves", report.curves},
          {"obstacles", report.obstacles},
          {"headlands", report.headlands},
          {"gaps", report.gaps},
          {"bytes", report.bytes},
          {"renamed", renamed_json(report.changed)}};
}

}  // namespace

void run_task_set_export(const ExportOptions& options) {
  require_zip_or_folder(options);
  io::TaskSetRequest request;
  request.plans = plan_paths(options);
  request.target = options.output;
  request.version = options.isoxml == "3" ? io::TaskDataVersion::k3 : io::TaskDataVersion::k4;
  request.lines = line_choice(options);
  request.obstacles =
      options.obstacles == "polygons" ? io::ObstacleStyle::kPolygons : io::ObstacleStyle::kHoles;
  request.tolerance_m = options.tolerance_m;
  request.field = options.id;
  request.customer = options.customer;
  request.farm = options.farm;
  const io::TaskSetReport report = io::export_task_set(request);
  print_report(options, table_of(report, options), json_of(report, options));
}

}  // namespace tramline::app
