#include <fmt/format.h>

#include <string>

#include "exports/export_parts.h"
#include "exports/export_runs.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {

void run_agopengps_export(const ExportOptions& options) {
  require_zip_or_folder(options);
  const io::AgOpenGpsReport report = io::export_agopengps(
      {plan_paths(options), options.output, line_choice(options), options.tolerance_m, options.id});
  const std::size_t fields = report.folders.size();
  const std::string table =
      fmt::format("{}: AgOpenGPS, {} field{}\n", options.output, fields, fields == 1 ? "" : "s") +
      count_row("AB lines", report.lines - report.curves) + count_row("curves", report.curves) +
      count_row("obstacles", report.obstacles) + renamed_rows(report.changed);
  print_report(options, table,
               {{"plans", options.plans},
                {"fields", fields},
                {"tolerance_m", options.tolerance_m},
                {"file", options.output},
                {"format", "AgOpenGPS"},
                {"folders", report.folders},
                {"lines", report.lines},
                {"curves", report.curves},
                {"obstacles", report.obstacles},
                {"renamed", renamed_json(report.changed)}});
}

}  // namespace tramline::app
